// Made of `data/ior` and `data/notes.csv` by `tests/materials/generate.rs`; not to be edited.

use super::constants::OpticalConstants;
use super::material::{Form, Kind, Material};

/// Silver, 292.4 to 1088 nm.
///
/// P. B. Johnson and R. W. Christy. Optical constants of the noble metals. Phys. Rev. B 6, 4370-4379 (1972) doi:10.1103/PhysRevB.6.4370
pub static SILVER: Material = Material {
    key: "Ag",
    name: "Silver",
    kind: Kind::Metal,
    citation: "P. B. Johnson and R. W. Christy. Optical constants of the noble metals. Phys. Rev. B 6, 4370-4379 (1972) doi:10.1103/PhysRevB.6.4370",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Ag.bin")),
};

/// Aluminium, 247.97 to 1033.2 nm.
///
/// A. D. Rakić. Algorithm for the determination of intrinsic optical constants of metal films: application to aluminum. Appl. Opt. 34, 4755-4767 (1995) doi:10.1364/AO.34.004755
pub static ALUMINIUM: Material = Material {
    key: "Al",
    name: "Aluminium",
    kind: Kind::Metal,
    citation: "A. D. Rakić. Algorithm for the determination of intrinsic optical constants of metal films: application to aluminum. Appl. Opt. 34, 4755-4767 (1995) doi:10.1364/AO.34.004755",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Al.bin")),
};

/// Gold, 292.4 to 1088 nm.
///
/// P. B. Johnson and R. W. Christy. Optical constants of the noble metals. Phys. Rev. B 6, 4370-4379 (1972) doi:10.1103/PhysRevB.6.4370
pub static GOLD: Material = Material {
    key: "Au",
    name: "Gold",
    kind: Kind::Metal,
    citation: "P. B. Johnson and R. W. Christy. Optical constants of the noble metals. Phys. Rev. B 6, 4370-4379 (1972) doi:10.1103/PhysRevB.6.4370",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Au.bin")),
};

/// Beryllium, 292.88 to 1020.8 nm.
///
/// Remark: values of a model fitted to several measurements and not samples of one.
///
/// A. D. Rakić, A. B. Djurišic, J. M. Elazar, M. L. Majewski. Optical properties of metallic films for vertical-cavity optoelectronic devices. Appl. Opt. 37, 5271-5283 (1998) doi:10.1364/AO.37.005271 \[Calculation script (Python)\]
pub static BERYLLIUM: Material = Material {
    key: "Be",
    name: "Beryllium",
    kind: Kind::Metal,
    citation: "A. D. Rakić, A. B. Djurišic, J. M. Elazar, M. L. Majewski. Optical properties of metallic films for vertical-cavity optoelectronic devices. Appl. Opt. 37, 5271-5283 (1998) doi:10.1364/AO.37.005271 [Calculation script (Python)]",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "table of a Brendel-Bormann model",
    remark: Some("values of a model fitted to several measurements and not samples of one"),
    constants: OpticalConstants::packed(include_bytes!("samples/Be.bin")),
};

/// Cobalt, 292 to 1088 nm.
///
/// P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056
pub static COBALT: Material = Material {
    key: "Co",
    name: "Cobalt",
    kind: Kind::Metal,
    citation: "P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Co.bin")),
};

/// Chromium, 292 to 1088 nm.
///
/// P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056
pub static CHROMIUM: Material = Material {
    key: "Cr",
    name: "Chromium",
    kind: Kind::Metal,
    citation: "P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Cr.bin")),
};

/// Copper, 292.4 to 1088 nm.
///
/// P. B. Johnson and R. W. Christy. Optical constants of the noble metals. Phys. Rev. B 6, 4370-4379 (1972) doi:10.1103/PhysRevB.6.4370
pub static COPPER: Material = Material {
    key: "Cu",
    name: "Copper",
    kind: Kind::Metal,
    citation: "P. B. Johnson and R. W. Christy. Optical constants of the noble metals. Phys. Rev. B 6, 4370-4379 (1972) doi:10.1103/PhysRevB.6.4370",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Cu.bin")),
};

/// Iron, 292 to 1088 nm.
///
/// P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056
pub static IRON: Material = Material {
    key: "Fe",
    name: "Iron",
    kind: Kind::Metal,
    citation: "P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Fe.bin")),
};

/// Mercury (liquid), 295.2 to 1033.2 nm.
///
/// T. Inagaki, E. T. Arakawa, and M. W. Williams. Optical properties of liquid mercury. Phys. Rev. B 23, 5246-5262 (1981) doi:10.1103/PhysRevB.23.5246
pub static MERCURY_LIQUID: Material = Material {
    key: "Hg",
    name: "Mercury (liquid)",
    kind: Kind::Metal,
    citation: "T. Inagaki, E. T. Arakawa, and M. W. Williams. Optical properties of liquid mercury. Phys. Rev. B 23, 5246-5262 (1981) doi:10.1103/PhysRevB.23.5246",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Hg.bin")),
};

/// Potassium, 312.539 to 1009.64 nm.
///
/// N. V. Smith. Optical constants of sodium and potassium from 0.5 to 4.0 eV by split-beam ellipsometry. Phs. Rev. 183, 634-644 (1969) doi:10.1103/PhysRev.183.634
pub static POTASSIUM: Material = Material {
    key: "K",
    name: "Potassium",
    kind: Kind::Metal,
    citation: "N. V. Smith. Optical constants of sodium and potassium from 0.5 to 4.0 eV by split-beam ellipsometry. Phs. Rev. 183, 634-644 (1969) doi:10.1103/PhysRev.183.634",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/K.bin")),
};

/// Magnesium, 299.511 to 1011.45 nm.
///
/// K. J. Palm, J. B. Murray, T. C. Narayan, J. N. Munday. Dynamic optical properties of metal hydrides. ACS Photonics 5, 4677-4686 (2018) doi:10.1021/acsphotonics.8b01243 (Numerical data kindly provided by Kevin Palm)
pub static MAGNESIUM: Material = Material {
    key: "Mg",
    name: "Magnesium",
    kind: Kind::Metal,
    citation: "K. J. Palm, J. B. Murray, T. C. Narayan, J. N. Munday. Dynamic optical properties of metal hydrides. ACS Photonics 5, 4677-4686 (2018) doi:10.1021/acsphotonics.8b01243 (Numerical data kindly provided by Kevin Palm)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Mg.bin")),
};

/// Manganese, 292 to 1088 nm.
///
/// P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056
pub static MANGANESE: Material = Material {
    key: "Mn",
    name: "Manganese",
    kind: Kind::Metal,
    citation: "P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Mn.bin")),
};

/// Molybdenum, 289 to 1100 nm.
///
/// M. M. Kirillova, L. V. Nomerovannaya, M. M. Noskov. Optical properties of molybdenum single crystals , Sov. Phys. JETP 33, 1210-1214 (1971)
pub static MOLYBDENUM: Material = Material {
    key: "Mo",
    name: "Molybdenum",
    kind: Kind::Metal,
    citation: "M. M. Kirillova, L. V. Nomerovannaya, M. M. Noskov. Optical properties of molybdenum single crystals , Sov. Phys. JETP 33, 1210-1214 (1971)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Mo.bin")),
};

/// Sodium, 326 to 1033 nm.
///
/// T. Inagaki, L. C. Emerson, E. T. Arakawa, M. W. Williams. Optical properties of solid Na and Li between 0.6 and 3.8 eV. Phs. Rev. B 13, 2305-2313 (1976) doi:10.1103/PhysRevB.13.2305
pub static SODIUM: Material = Material {
    key: "Na",
    name: "Sodium",
    kind: Kind::Metal,
    citation: "T. Inagaki, L. C. Emerson, E. T. Arakawa, M. W. Williams. Optical properties of solid Na and Li between 0.6 and 3.8 eV. Phs. Rev. B 13, 2305-2313 (1976) doi:10.1103/PhysRevB.13.2305",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Na.bin")),
};

/// Niobium, 293.6 to 862.1 nm.
///
/// Remark: the source shows a figure that was digitised.
///
/// J. H. Weaver, D. W. Lynch, C. G. Olson. Optical properties of niobium from 0.1 to 36.4 eV. Phys. Rev. B 7, 4311-4318 (1973) doi:10.1103/PhysRevB.7.4311 (Data points extracted from a figure)
pub static NIOBIUM: Material = Material {
    key: "Nb",
    name: "Niobium",
    kind: Kind::Metal,
    citation: "J. H. Weaver, D. W. Lynch, C. G. Olson. Optical properties of niobium from 0.1 to 36.4 eV. Phys. Rev. B 7, 4311-4318 (1973) doi:10.1103/PhysRevB.7.4311 (Data points extracted from a figure)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "samples read off a figure",
    remark: Some("the source shows a figure that was digitised"),
    constants: OpticalConstants::packed(include_bytes!("samples/Nb.bin")),
};

/// Nickel, 292 to 1088 nm.
///
/// P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056
pub static NICKEL: Material = Material {
    key: "Ni",
    name: "Nickel",
    kind: Kind::Metal,
    citation: "P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Ni.bin")),
};

/// Lead, 344.4 to 1033.2 nm.
///
/// A. G. Mathewson and H. P. Myers. Absolute values of the optical constants of some pure metals. Phys. Scr. 4, 291-292 (1971) doi:10.1088/0031-8949/4/6/009
pub static LEAD: Material = Material {
    key: "Pb",
    name: "Lead",
    kind: Kind::Metal,
    citation: "A. G. Mathewson and H. P. Myers. Absolute values of the optical constants of some pure metals. Phys. Scr. 4, 291-292 (1971) doi:10.1088/0031-8949/4/6/009",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Pb.bin")),
};

/// Palladium, 292 to 1088 nm.
///
/// P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056
pub static PALLADIUM: Material = Material {
    key: "Pd",
    name: "Palladium",
    kind: Kind::Metal,
    citation: "P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Pd.bin")),
};

/// Platinum, 295.96 to 1001.3 nm.
///
/// Remark: values of a model fitted to several measurements and not samples of one.
///
/// A. D. Rakić, A. B. Djurišic, J. M. Elazar, M. L. Majewski. Optical properties of metallic films for vertical-cavity optoelectronic devices. Appl. Opt. 37, 5271-5283 (1998) doi:10.1364/AO.37.005271 \[Calculation script (Python)\]
pub static PLATINUM: Material = Material {
    key: "Pt",
    name: "Platinum",
    kind: Kind::Metal,
    citation: "A. D. Rakić, A. B. Djurišic, J. M. Elazar, M. L. Majewski. Optical properties of metallic films for vertical-cavity optoelectronic devices. Appl. Opt. 37, 5271-5283 (1998) doi:10.1364/AO.37.005271 [Calculation script (Python)]",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "table of a Brendel-Bormann model",
    remark: Some("values of a model fitted to several measurements and not samples of one"),
    constants: OpticalConstants::packed(include_bytes!("samples/Pt.bin")),
};

/// Rhodium, 295.2 to 1033 nm.
///
/// 1) J. H. Weaver, C. G. Olson, D. W. Lynch. Optical investigation of the electronic structure of bulk Rh and Ir. Phys. Rev. B 15, 4115 (1977) doi:10.1103/PhysRevB.15.4115 2) Handbook of Optical Constants of Solids, Edward D. Palik, ed. Academic Press, Boston, 1985 \* Ref. 2 provides numerical values for the graphical data reported in Ref. 1
pub static RHODIUM: Material = Material {
    key: "Rh",
    name: "Rhodium",
    kind: Kind::Metal,
    citation: "1) J. H. Weaver, C. G. Olson, D. W. Lynch. Optical investigation of the electronic structure of bulk Rh and Ir. Phys. Rev. B 15, 4115 (1977) doi:10.1103/PhysRevB.15.4115 2) Handbook of Optical Constants of Solids, Edward D. Palik, ed. Academic Press, Boston, 1985 * Ref. 2 provides numerical values for the graphical data reported in Ref. 1",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Rh.bin")),
};

/// Tantalum, 291.728 to 1239.84 nm.
///
/// **Not for colour:** from electron energy loss spectra; R about 0.84 in the visible against about 0.36-0.45 in Palik: do not use for colour.
///
/// W. S. M. Werner, K. Glantschnig, C. Ambrosch-Draxl. Optical constants and inelastic electron-scattering data for 17 elemental metals. J. Phys Chem Ref. Data 38, 1013-1092 (2009) doi:10.1063/1.3243762
pub static TANTALUM: Material = Material {
    key: "Ta",
    name: "Tantalum",
    kind: Kind::Caution,
    citation: "W. S. M. Werner, K. Glantschnig, C. Ambrosch-Draxl. Optical constants and inelastic electron-scattering data for 17 elemental metals. J. Phys Chem Ref. Data 38, 1013-1092 (2009) doi:10.1063/1.3243762",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: Some("from electron energy loss spectra; R about 0.84 in the visible against about 0.36-0.45 in Palik: do not use for colour"),
    constants: OpticalConstants::packed(include_bytes!("samples/Ta.bin")),
};

/// Titanium, 292 to 1088 nm.
///
/// P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056
pub static TITANIUM: Material = Material {
    key: "Ti",
    name: "Titanium",
    kind: Kind::Metal,
    citation: "P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Ti.bin")),
};

/// Vanadium, 292 to 1088 nm.
///
/// P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056
pub static VANADIUM: Material = Material {
    key: "V",
    name: "Vanadium",
    kind: Kind::Metal,
    citation: "P. B. Johnson and R. W. Christy. Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd. Phys. Rev. B 9, 5056-5070 (1974) doi:10.1103/PhysRevB.9.5056",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/V.bin")),
};

/// Tungsten, 297.9 to 1005 nm.
///
/// Remark: the source shows a figure that was digitised.
///
/// J. H. Weaver, C. G. Olson, D. W. Lynch. Optical properties of crystalline tungsten. Phys. Rev. B 12, 1293-1297 (1975) doi:10.1103/PhysRevB.12.1293 (Data points extracted from a figure)
pub static TUNGSTEN: Material = Material {
    key: "W",
    name: "Tungsten",
    kind: Kind::Metal,
    citation: "J. H. Weaver, C. G. Olson, D. W. Lynch. Optical properties of crystalline tungsten. Phys. Rev. B 12, 1293-1297 (1975) doi:10.1103/PhysRevB.12.1293 (Data points extracted from a figure)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "samples read off a figure",
    remark: Some("the source shows a figure that was digitised"),
    constants: OpticalConstants::packed(include_bytes!("samples/W.bin")),
};

/// Zinc, 360 to 1040 nm.
///
/// **Not for colour:** n reaches 13.9 at 560 nm, where the reflectance falls from 0.77 at normal incidence to 0.50 at 86 degrees, further than that of any other metal: do not use for colour.
///
/// M. R. Querry. Optical constants of minerals and other materials from the millimeter to the ultraviolet, Contractor Report CRDEC-CR-88009 (1987)
pub static ZINC: Material = Material {
    key: "Zn",
    name: "Zinc",
    kind: Kind::Caution,
    citation: "M. R. Querry. Optical constants of minerals and other materials from the millimeter to the ultraviolet, Contractor Report CRDEC-CR-88009 (1987)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: Some("n reaches 13.9 at 560 nm, where the reflectance falls from 0.77 at normal incidence to 0.50 at 86 degrees, further than that of any other metal: do not use for colour"),
    constants: OpticalConstants::packed(include_bytes!("samples/Zn.bin")),
};

/// Brass (70% Cu, 30% Zn), 290 to 1010 nm.
///
/// M. R. Querry. Optical constants, Contractor Report CRDC-CR-85034 (1985)
pub static BRASS_70_CU_30_ZN: Material = Material {
    key: "brass_Cu70Zn30",
    name: "Brass (70% Cu, 30% Zn)",
    kind: Kind::Alloy,
    citation: "M. R. Querry. Optical constants, Contractor Report CRDC-CR-85034 (1985)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/brass_Cu70Zn30.bin")),
};

/// Red brass (85% Cu, 15% Zn), 290 to 1010 nm.
///
/// M. R. Querry. Optical constants, Contractor Report CRDC-CR-85034 (1985)
pub static RED_BRASS_85_CU_15_ZN: Material = Material {
    key: "brass_Cu85Zn15",
    name: "Red brass (85% Cu, 15% Zn)",
    kind: Kind::Alloy,
    citation: "M. R. Querry. Optical constants, Contractor Report CRDC-CR-85034 (1985)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/brass_Cu85Zn15.bin")),
};

/// Stainless steel (austenitic), 280 to 1020 nm.
///
/// Remark: the source shows a figure that was digitised.
///
/// Björn Karlsson, Carl G. Ribbing. Optical constants and spectral selectivity of stainless steel and its oxides. J. Appl. Phys. 53, 6340-6346 (1982) doi:10.1063/1.331503 (Data extracted from a figure)
pub static STAINLESS_STEEL_AUSTENITIC: Material = Material {
    key: "stainless_steel",
    name: "Stainless steel (austenitic)",
    kind: Kind::Alloy,
    citation: "Björn Karlsson, Carl G. Ribbing. Optical constants and spectral selectivity of stainless steel and its oxides. J. Appl. Phys. 53, 6340-6346 (1982) doi:10.1063/1.331503 (Data extracted from a figure)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "samples read off a figure",
    remark: Some("the source shows a figure that was digitised"),
    constants: OpticalConstants::packed(include_bytes!("samples/stainless_steel.bin")),
};

/// Gold-silver alloy (50/50), 299 to 1001 nm.
///
/// Remark: values of an analytic model of alloys of gold and silver and not of a measured sample.
///
/// D. Rioux, S. Vallières, S. Besner, P. Muñoz, E. Mazur, M. Meunier. An analytic model for the dielectric function of Au, Ag, and their alloys. Adv. Opt. Mater. 2, 176-182 (2014) doi:10.1002/adom.201300457 (See Supporting information for MATLAB model)
pub static GOLD_SILVER_ALLOY_50_50: Material = Material {
    key: "electrum_Au50Ag50",
    name: "Gold-silver alloy (50/50)",
    kind: Kind::Alloy,
    citation: "D. Rioux, S. Vallières, S. Besner, P. Muñoz, E. Mazur, M. Meunier. An analytic model for the dielectric function of Au, Ag, and their alloys. Adv. Opt. Mater. 2, 176-182 (2014) doi:10.1002/adom.201300457 (See Supporting information for MATLAB model)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "table of an analytic model",
    remark: Some("values of an analytic model of alloys of gold and silver and not of a measured sample"),
    constants: OpticalConstants::packed(include_bytes!("samples/electrum_Au50Ag50.bin")),
};

/// Silver (McPeak 2015), 300 to 1010 nm.
///
/// K. M. McPeak, S. V. Jayanti, S. J. P. Kress, S. Meyer, S. Iotti, A. Rossinelli, D. J. Norris. Plasmonic films can easily be better: Rules and recipes. ACS Photonics 2, 326-333 (2015) doi:10.1021/ph5004237
pub static SILVER_MCPEAK_2015: Material = Material {
    key: "Ag_mcpeak",
    name: "Silver (McPeak 2015)",
    kind: Kind::Alternative,
    citation: "K. M. McPeak, S. V. Jayanti, S. J. P. Kress, S. Meyer, S. Iotti, A. Rossinelli, D. J. Norris. Plasmonic films can easily be better: Rules and recipes. ACS Photonics 2, 326-333 (2015) doi:10.1021/ph5004237",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Ag_mcpeak.bin")),
};

/// Aluminium (McPeak 2015), 295 to 1005 nm.
///
/// K. M. McPeak, S. V. Jayanti, S. J. P. Kress, S. Meyer, S. Iotti, A. Rossinelli, D. J. Norris. Plasmonic films can easily be better: Rules and recipes. ACS Photonics 2, 326-333 (2015) doi:10.1021/ph5004237
pub static ALUMINIUM_MCPEAK_2015: Material = Material {
    key: "Al_mcpeak",
    name: "Aluminium (McPeak 2015)",
    kind: Kind::Alternative,
    citation: "K. M. McPeak, S. V. Jayanti, S. J. P. Kress, S. Meyer, S. Iotti, A. Rossinelli, D. J. Norris. Plasmonic films can easily be better: Rules and recipes. ACS Photonics 2, 326-333 (2015) doi:10.1021/ph5004237",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Al_mcpeak.bin")),
};

/// Gold (McPeak 2015), 300 to 1010 nm.
///
/// K. M. McPeak, S. V. Jayanti, S. J. P. Kress, S. Meyer, S. Iotti, A. Rossinelli, D. J. Norris. Plasmonic films can easily be better: Rules and recipes. ACS Photonics 2, 326-333 (2015) doi:10.1021/ph5004237
pub static GOLD_MCPEAK_2015: Material = Material {
    key: "Au_mcpeak",
    name: "Gold (McPeak 2015)",
    kind: Kind::Alternative,
    citation: "K. M. McPeak, S. V. Jayanti, S. J. P. Kress, S. Meyer, S. Iotti, A. Rossinelli, D. J. Norris. Plasmonic films can easily be better: Rules and recipes. ACS Photonics 2, 326-333 (2015) doi:10.1021/ph5004237",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Au_mcpeak.bin")),
};

/// Copper (McPeak 2015), 300 to 1010 nm.
///
/// K. M. McPeak, S. V. Jayanti, S. J. P. Kress, S. Meyer, S. Iotti, A. Rossinelli, D. J. Norris. Plasmonic films can easily be better: Rules and recipes. ACS Photonics 2, 326-333 (2015) doi:10.1021/ph5004237
pub static COPPER_MCPEAK_2015: Material = Material {
    key: "Cu_mcpeak",
    name: "Copper (McPeak 2015)",
    kind: Kind::Alternative,
    citation: "K. M. McPeak, S. V. Jayanti, S. J. P. Kress, S. Meyer, S. Iotti, A. Rossinelli, D. J. Norris. Plasmonic films can easily be better: Rules and recipes. ACS Photonics 2, 326-333 (2015) doi:10.1021/ph5004237",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Cu_mcpeak.bin")),
};

/// Molybdenum (Querry 1987), 280 to 1020 nm.
///
/// M. R. Querry. Optical constants of minerals and other materials from the millimeter to the ultraviolet, Contractor Report CRDEC-CR-88009 (1987)
pub static MOLYBDENUM_QUERRY_1987: Material = Material {
    key: "Mo_querry",
    name: "Molybdenum (Querry 1987)",
    kind: Kind::Alternative,
    citation: "M. R. Querry. Optical constants of minerals and other materials from the millimeter to the ultraviolet, Contractor Report CRDEC-CR-88009 (1987)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Mo_querry.bin")),
};

/// Platinum (Tselin), 299.285 to 1001.36 nm.
///
/// A. Tselin, M. Pogodaeva, S. Levchenko, A. Kalmykov, K. Garbuzov, A. Smirnov, V. Drachev. Exploring the dielectric function of platinum. Phys. Rev. B 110, 195130 (2024) doi:10.1103/PhysRevB.110.195130 (Numerical data kindly provided by Andrey Tselin)
pub static PLATINUM_TSELIN: Material = Material {
    key: "Pt_tselin",
    name: "Platinum (Tselin)",
    kind: Kind::Alternative,
    citation: "A. Tselin, M. Pogodaeva, S. Levchenko, A. Kalmykov, K. Garbuzov, A. Smirnov, V. Drachev. Exploring the dielectric function of platinum. Phys. Rev. B 110, 195130 (2024) doi:10.1103/PhysRevB.110.195130 (Numerical data kindly provided by Andrey Tselin)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Pt_tselin.bin")),
};

/// Chromium (Sytchkova), 299.54 to 1015.6 nm.
///
/// A. Sytchkova, A. Belosludtsev, L. Volosevičienė, R. Juškėnas, R. Simniškis. Optical, structural and electrical properties of sputtered ultrathin chromium films. Opt. Mater. 121, 111530 (2021) doi:10.1016/j.optmat.2021.111530 (Numerical data kindly provided by Alexandr Belosludtsev)
pub static CHROMIUM_SYTCHKOVA: Material = Material {
    key: "Cr_sytchkova",
    name: "Chromium (Sytchkova)",
    kind: Kind::Alternative,
    citation: "A. Sytchkova, A. Belosludtsev, L. Volosevičienė, R. Juškėnas, R. Simniškis. Optical, structural and electrical properties of sputtered ultrathin chromium films. Opt. Mater. 121, 111530 (2021) doi:10.1016/j.optmat.2021.111530 (Numerical data kindly provided by Alexandr Belosludtsev)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Cr_sytchkova.bin")),
};

/// Titanium (Rakic 1998 BB), 293.87 to 1012.9 nm.
///
/// Remark: values of a model fitted to several measurements and not samples of one.
///
/// A. D. Rakić, A. B. Djurišic, J. M. Elazar, M. L. Majewski. Optical properties of metallic films for vertical-cavity optoelectronic devices. Appl. Opt. 37, 5271-5283 (1998) doi:10.1364/AO.37.005271 \[Calculation script (Python)\]
pub static TITANIUM_RAKIC_1998_BB: Material = Material {
    key: "Ti_rakic",
    name: "Titanium (Rakic 1998 BB)",
    kind: Kind::Alternative,
    citation: "A. D. Rakić, A. B. Djurišic, J. M. Elazar, M. L. Majewski. Optical properties of metallic films for vertical-cavity optoelectronic devices. Appl. Opt. 37, 5271-5283 (1998) doi:10.1364/AO.37.005271 [Calculation script (Python)]",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "table of a Brendel-Bormann model",
    remark: Some("values of a model fitted to several measurements and not samples of one"),
    constants: OpticalConstants::packed(include_bytes!("samples/Ti_rakic.bin")),
};

/// Tungsten (Rakic 1998 BB), 295.96 to 1001.3 nm.
///
/// Remark: values of a model fitted to several measurements and not samples of one.
///
/// A. D. Rakić, A. B. Djurišic, J. M. Elazar, and M. L. Majewski. Optical properties of metallic films for vertical-cavity optoelectronic devices. Appl. Opt. 37, 5271-5283 (1998) \[Calculation script (Python) doi:10.1364/AO.37.005271\]
pub static TUNGSTEN_RAKIC_1998_BB: Material = Material {
    key: "W_rakic",
    name: "Tungsten (Rakic 1998 BB)",
    kind: Kind::Alternative,
    citation: "A. D. Rakić, A. B. Djurišic, J. M. Elazar, and M. L. Majewski. Optical properties of metallic films for vertical-cavity optoelectronic devices. Appl. Opt. 37, 5271-5283 (1998) [Calculation script (Python) doi:10.1364/AO.37.005271]",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "table of a Brendel-Bormann model",
    remark: Some("values of a model fitted to several measurements and not samples of one"),
    constants: OpticalConstants::packed(include_bytes!("samples/W_rakic.bin")),
};

/// Silicon, 295.2 to 826.6 nm.
///
/// D. E. Aspnes and A. A. Studna. Dielectric functions and optical parameters of Si, Ge, GaP, GaAs, GaSb, InP, InAs, and InSb from 1.5 to 6.0 eV. Phys. Rev. B 27, 985-1009 (1983) doi:10.1103/PhysRevB.27.985
pub static SILICON: Material = Material {
    key: "Si",
    name: "Silicon",
    kind: Kind::Semiconductor,
    citation: "D. E. Aspnes and A. A. Studna. Dielectric functions and optical parameters of Si, Ge, GaP, GaAs, GaSb, InP, InAs, and InSb from 1.5 to 6.0 eV. Phys. Rev. B 27, 985-1009 (1983) doi:10.1103/PhysRevB.27.985",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Si.bin")),
};

/// Germanium, 295.2 to 826.6 nm.
///
/// D. E. Aspnes and A. A. Studna. Dielectric functions and optical parameters of Si, Ge, GaP, GaAs, GaSb, InP, InAs, and InSb from 1.5 to 6.0 eV. Phys. Rev. B 27, 985-1009 (1983) doi:10.1103/PhysRevB.27.985
pub static GERMANIUM: Material = Material {
    key: "Ge",
    name: "Germanium",
    kind: Kind::Semiconductor,
    citation: "D. E. Aspnes and A. A. Studna. Dielectric functions and optical parameters of Si, Ge, GaP, GaAs, GaSb, InP, InAs, and InSb from 1.5 to 6.0 eV. Phys. Rev. B 27, 985-1009 (1983) doi:10.1103/PhysRevB.27.985",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/Ge.bin")),
};

/// Air (standard), 300 to 1000 nm.
///
/// P. E. Ciddor. Refractive index of air: new equations for the visible and near infrared. Appl. Optics 35, 1566-1573 (1996) doi:10.1364/AO.35.001566 \[Calculation script (Python) - can be used to calculate the refractive index of air for specific values of humidity, temperature, pressure, and CO2 concentration\]
pub static AIR_STANDARD: Material = Material {
    key: "air",
    name: "Air (standard)",
    kind: Kind::Dielectric,
    citation: "P. E. Ciddor. Refractive index of air: new equations for the visible and near infrared. Appl. Optics 35, 1566-1573 (1996) doi:10.1364/AO.35.001566 [Calculation script (Python) - can be used to calculate the refractive index of air for specific values of humidity, temperature, pressure, and CO2 concentration]",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 6 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/air.bin")),
};

/// Water (Hale & Querry 1973), 275 to 1200 nm.
///
/// G. M. Hale and M. R. Querry. Optical constants of water in the 200-nm to 200-µm wavelength region. Appl. Opt. 12, 555-563 (1973) doi:10.1364/AO.12.000555 See also Segelstein 1981 for more recent data from the same group.
pub static WATER_HALE_QUERRY_1973: Material = Material {
    key: "water",
    name: "Water (Hale & Querry 1973)",
    kind: Kind::Dielectric,
    citation: "G. M. Hale and M. R. Querry. Optical constants of water in the 200-nm to 200-µm wavelength region. Appl. Opt. 12, 555-563 (1973) doi:10.1364/AO.12.000555 See also Segelstein 1981 for more recent data from the same group.",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/water.bin")),
};

/// Water 20 C (Daimon 2007), 300 to 1000 nm.
///
/// M. Daimon and A. Masumura. Measurement of the refractive index of distilled water from the near-infrared region to the ultraviolet region. Appl. Opt. 46, 3811-3820 (2007) doi:10.1364/AO.46.003811
pub static WATER_20_C_DAIMON_2007: Material = Material {
    key: "water_daimon",
    name: "Water 20 C (Daimon 2007)",
    kind: Kind::Dielectric,
    citation: "M. Daimon and A. Masumura. Measurement of the refractive index of distilled water from the near-infrared region to the ultraviolet region. Appl. Opt. 46, 3811-3820 (2007) doi:10.1364/AO.46.003811",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/water_daimon.bin")),
};

/// Ice (Warren & Brandt 2008), 250 to 1010 nm.
///
/// S. G. Warren and R. E. Brandt. Optical constants of ice from the ultraviolet to the microwave: A revised compilation. J. Geophys. Res. 113, D14220 (2008) doi:10.1029/2007JD009744 Optical constants available online at <https://atmos.washington.edu/ice_optical_constants/>
pub static ICE_WARREN_BRANDT_2008: Material = Material {
    key: "ice",
    name: "Ice (Warren & Brandt 2008)",
    kind: Kind::Dielectric,
    citation: "S. G. Warren and R. E. Brandt. Optical constants of ice from the ultraviolet to the microwave: A revised compilation. J. Geophys. Res. 113, D14220 (2008) doi:10.1029/2007JD009744 Optical constants available online at https://atmos.washington.edu/ice_optical_constants/",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/ice.bin")),
};

/// N-BK7 glass (Schott), 300 to 1000 nm.
///
/// SCHOTT Zemax catalog 2017-01-20b (obtained from <http://www.schott.com>) See also SCHOTT glass data sheets
pub static N_BK7_GLASS_SCHOTT: Material = Material {
    key: "BK7",
    name: "N-BK7 glass (Schott)",
    kind: Kind::Dielectric,
    citation: "SCHOTT Zemax catalog 2017-01-20b (obtained from http://www.schott.com) See also SCHOTT glass data sheets",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; k interpolated from its table",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/BK7.bin")),
};

/// SF11 glass (Schott, leaded), 390 to 1000 nm.
///
/// Remark: starts at 390 nm.
///
/// SCHOTT Zemax catalog 2017-01-20b (obtained from <http://www.schott.com>)See also SCHOTT glass data sheets
pub static SF11_GLASS_SCHOTT_LEADED: Material = Material {
    key: "SF11",
    name: "SF11 glass (Schott, leaded)",
    kind: Kind::Dielectric,
    citation: "SCHOTT Zemax catalog 2017-01-20b (obtained from http://www.schott.com)See also SCHOTT glass data sheets",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; k interpolated from its table",
    remark: Some("starts at 390 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/SF11.bin")),
};

/// N-SF11 glass (Schott), 370 to 1000 nm.
///
/// SCHOTT Zemax catalog 2017-01-20b (obtained from <http://www.schott.com>)See also SCHOTT glass data sheets
pub static N_SF11_GLASS_SCHOTT: Material = Material {
    key: "N-SF11",
    name: "N-SF11 glass (Schott)",
    kind: Kind::Dielectric,
    citation: "SCHOTT Zemax catalog 2017-01-20b (obtained from http://www.schott.com)See also SCHOTT glass data sheets",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; k interpolated from its table",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/N-SF11.bin")),
};

/// Soda-lime window glass, clear, 310 to 1000 nm.
///
/// M. Rubin. Optical properties of soda lime silica glasses. Sol. Energy Mater. 12, 275-288 (1985) doi:10.1016/0165-1633(85)90052-8
pub static SODA_LIME_WINDOW_GLASS_CLEAR: Material = Material {
    key: "soda_lime",
    name: "Soda-lime window glass, clear",
    kind: Kind::Dielectric,
    citation: "M. Rubin. Optical properties of soda lime silica glasses. Sol. Energy Mater. 12, 275-288 (1985) doi:10.1016/0165-1633(85)90052-8",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 5 evaluated every 5 nm; k interpolated from its table",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/soda_lime.bin")),
};

/// Fused silica, 300 to 1000 nm.
///
/// 1) I. H. Malitson. Interspecimen comparison of the refractive index of fused silica. J. Opt. Soc. Am. 55, 1205-1208 (1965) doi:10.1364/JOSA.55.001205 2) C. Z. Tan. Determination of refractive index of silica glass for infrared wavelengths by IR spectroscopy. J. Non-Cryst. Solids 223, 158-163 (1998) doi:10.1016/S0022-3093(97)00438-9 \* Sellmeier formula is reported in Ref. 1 for the 0.21–3.71 μm wavelength range. Ref. 2 verifies the validity of the formula up to 6.7 μm.
pub static FUSED_SILICA: Material = Material {
    key: "fused_silica",
    name: "Fused silica",
    kind: Kind::Dielectric,
    citation: "1) I. H. Malitson. Interspecimen comparison of the refractive index of fused silica. J. Opt. Soc. Am. 55, 1205-1208 (1965) doi:10.1364/JOSA.55.001205 2) C. Z. Tan. Determination of refractive index of silica glass for infrared wavelengths by IR spectroscopy. J. Non-Cryst. Solids 223, 158-163 (1998) doi:10.1016/S0022-3093(97)00438-9 * Sellmeier formula is reported in Ref. 1 for the 0.21–3.71 μm wavelength range. Ref. 2 verifies the validity of the formula up to 6.7 μm.",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 1 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/fused_silica.bin")),
};

/// Quartz, ordinary ray, 300 to 1000 nm.
///
/// G. Ghosh. Dispersion-equation coefficients for the refractive index and birefringence of calcite and quartz crystals. Opt. Commun. 163, 95-102 (1999) doi:10.1016/S0030-4018(99)00091-7
pub static QUARTZ_ORDINARY_RAY: Material = Material {
    key: "quartz_o",
    name: "Quartz, ordinary ray",
    kind: Kind::Dielectric,
    citation: "G. Ghosh. Dispersion-equation coefficients for the refractive index and birefringence of calcite and quartz crystals. Opt. Commun. 163, 95-102 (1999) doi:10.1016/S0030-4018(99)00091-7",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/quartz_o.bin")),
};

/// Quartz, extraordinary ray, 300 to 1000 nm.
///
/// G. Ghosh. Dispersion-equation coefficients for the refractive index and birefringence of calcite and quartz crystals. Opt. Commun. 163, 95-102 (1999) doi:10.1016/S0030-4018(99)00091-7
pub static QUARTZ_EXTRAORDINARY_RAY: Material = Material {
    key: "quartz_e",
    name: "Quartz, extraordinary ray",
    kind: Kind::Dielectric,
    citation: "G. Ghosh. Dispersion-equation coefficients for the refractive index and birefringence of calcite and quartz crystals. Opt. Commun. 163, 95-102 (1999) doi:10.1016/S0030-4018(99)00091-7",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/quartz_e.bin")),
};

/// Sapphire, ordinary ray, 300 to 1000 nm.
///
/// 1) I. H. Malitson and M. J. Dodge. Refractive index and birefringence of synthetic sapphire. J. Opt. Soc. Am. 62, 1405 (1972) 2) M. J. Dodge. "Refractive index" in Handbook of Laser Science and Technology, Volume IV, Optical Materials: Part 2, CRC Press, Boca Raton, 1986, p. 30 \* Ref. 1 is a talk abstract in a conference program; Ref. 2 provides a dispersion formula
pub static SAPPHIRE_ORDINARY_RAY: Material = Material {
    key: "sapphire_o",
    name: "Sapphire, ordinary ray",
    kind: Kind::Dielectric,
    citation: "1) I. H. Malitson and M. J. Dodge. Refractive index and birefringence of synthetic sapphire. J. Opt. Soc. Am. 62, 1405 (1972) 2) M. J. Dodge. \"Refractive index\" in Handbook of Laser Science and Technology, Volume IV, Optical Materials: Part 2, CRC Press, Boca Raton, 1986, p. 30 * Ref. 1 is a talk abstract in a conference program; Ref. 2 provides a dispersion formula",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 1 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/sapphire_o.bin")),
};

/// Sapphire, extraordinary ray, 300 to 1000 nm.
///
/// 1) I. H. Malitson and M. J. Dodge. Refractive index and birefringence of synthetic sapphire. J. Opt. Soc. Am. 62, 1405 (1972) 2) M. J. Dodge. "Refractive index" in Handbook of Laser Science and Technology, Volume IV, Optical Materials: Part 2, CRC Press, Boca Raton, 1986, p. 30 \* Ref. 1 is a talk abstract in a conference program; Ref. 2 provides a dispersion formula
pub static SAPPHIRE_EXTRAORDINARY_RAY: Material = Material {
    key: "sapphire_e",
    name: "Sapphire, extraordinary ray",
    kind: Kind::Dielectric,
    citation: "1) I. H. Malitson and M. J. Dodge. Refractive index and birefringence of synthetic sapphire. J. Opt. Soc. Am. 62, 1405 (1972) 2) M. J. Dodge. \"Refractive index\" in Handbook of Laser Science and Technology, Volume IV, Optical Materials: Part 2, CRC Press, Boca Raton, 1986, p. 30 * Ref. 1 is a talk abstract in a conference program; Ref. 2 provides a dispersion formula",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 1 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/sapphire_e.bin")),
};

/// Diamond (Phillip & Taft 1964), 295.2 to 1033.2 nm.
///
/// H. R. Phillip and E. A. Taft. Kramers-Kronig analysis of reflectance data for diamond. Phys. Rev. 136, A1445-A1448 (1964) doi:10.1103/PhysRev.136.A1445
pub static DIAMOND_PHILLIP_TAFT_1964: Material = Material {
    key: "diamond",
    name: "Diamond (Phillip & Taft 1964)",
    kind: Kind::Dielectric,
    citation: "H. R. Phillip and E. A. Taft. Kramers-Kronig analysis of reflectance data for diamond. Phys. Rev. 136, A1445-A1448 (1964) doi:10.1103/PhysRev.136.A1445",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/diamond.bin")),
};

/// Diamond (Peter 1923), 300 to 760 nm.
///
/// Remark: ends at 760 nm.
///
/// F. Peter. Über Brechungsindizes und Absorptionskonstanten des Diamanten zwischen 644 und 226 mμ. Zeitschrift für Physik 15, 358-368 (1923) doi:10.1007/BF01330487
pub static DIAMOND_PETER_1923: Material = Material {
    key: "diamond_peter",
    name: "Diamond (Peter 1923)",
    kind: Kind::Dielectric,
    citation: "F. Peter. Über Brechungsindizes und Absorptionskonstanten des Diamanten zwischen 644 und 226 mμ. Zeitschrift für Physik 15, 358-368 (1923) doi:10.1007/BF01330487",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 1 evaluated every 5 nm; no k in the set, written as 0",
    remark: Some("ends at 760 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/diamond_peter.bin")),
};

/// Sodium chloride (halite), 300 to 1000 nm.
///
/// H. H. Li. Refractive index of alkali halides and its wavelength and temperature derivatives. J. Phys. Chem. Ref. Data 5, 329-528 (1976) doi:10.1063/1.555536 and references therein. \* Sellmeier formula is derived by critical analysis of experimental data from several sources.
pub static SODIUM_CHLORIDE_HALITE: Material = Material {
    key: "NaCl",
    name: "Sodium chloride (halite)",
    kind: Kind::Dielectric,
    citation: "H. H. Li. Refractive index of alkali halides and its wavelength and temperature derivatives. J. Phys. Chem. Ref. Data 5, 329-528 (1976) doi:10.1063/1.555536 and references therein. * Sellmeier formula is derived by critical analysis of experimental data from several sources.",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 1 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/NaCl.bin")),
};

/// Potassium chloride, 300 to 1000 nm.
///
/// H. H. Li. Refractive index of alkali halides and its wavelength and temperature derivatives. J. Phys. Chem. Ref. Data 5, 329-528 (1976) doi:10.1063/1.555536 and references therein. \* Sellmeier formula is derived by critical analysis of experimental data from several sources.
pub static POTASSIUM_CHLORIDE: Material = Material {
    key: "KCl",
    name: "Potassium chloride",
    kind: Kind::Dielectric,
    citation: "H. H. Li. Refractive index of alkali halides and its wavelength and temperature derivatives. J. Phys. Chem. Ref. Data 5, 329-528 (1976) doi:10.1063/1.555536 and references therein. * Sellmeier formula is derived by critical analysis of experimental data from several sources.",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 1 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/KCl.bin")),
};

/// Fluorite, 300 to 1000 nm.
///
/// I. H. Malitson. A redetermination of some optical properties of calcium fluoride. Appl. Opt. 2, 1103-1107 (1963) doi:10.1364/AO.2.001103
pub static FLUORITE: Material = Material {
    key: "CaF2",
    name: "Fluorite",
    kind: Kind::Dielectric,
    citation: "I. H. Malitson. A redetermination of some optical properties of calcium fluoride. Appl. Opt. 2, 1103-1107 (1963) doi:10.1364/AO.2.001103",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 1 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/CaF2.bin")),
};

/// Magnesium fluoride, ordinary ray, 300 to 1000 nm.
///
/// M. J. Dodge. Refractive properties of magnesium fluoride. Appl. Opt. 23, 1980-1985 (1984) doi:10.1364/AO.23.001980
pub static MAGNESIUM_FLUORIDE_ORDINARY_RAY: Material = Material {
    key: "MgF2_o",
    name: "Magnesium fluoride, ordinary ray",
    kind: Kind::Dielectric,
    citation: "M. J. Dodge. Refractive properties of magnesium fluoride. Appl. Opt. 23, 1980-1985 (1984) doi:10.1364/AO.23.001980",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 1 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/MgF2_o.bin")),
};

/// Magnesium fluoride, extraordinary ray, 300 to 1000 nm.
///
/// M. J. Dodge. Refractive properties of magnesium fluoride. Appl. Opt. 23, 1980-1985 (1984) doi:10.1364/AO.23.001980
pub static MAGNESIUM_FLUORIDE_EXTRAORDINARY_RAY: Material = Material {
    key: "MgF2_e",
    name: "Magnesium fluoride, extraordinary ray",
    kind: Kind::Dielectric,
    citation: "M. J. Dodge. Refractive properties of magnesium fluoride. Appl. Opt. 23, 1980-1985 (1984) doi:10.1364/AO.23.001980",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 1 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/MgF2_e.bin")),
};

/// Calcite, ordinary ray, 300 to 1000 nm.
///
/// G. Ghosh. Dispersion-equation coefficients for the refractive index and birefringence of calcite and quartz crystals. Opt. Commun. 163, 95-102 (1999) doi:10.1016/S0030-4018(99)00091-7
pub static CALCITE_ORDINARY_RAY: Material = Material {
    key: "calcite_o",
    name: "Calcite, ordinary ray",
    kind: Kind::Dielectric,
    citation: "G. Ghosh. Dispersion-equation coefficients for the refractive index and birefringence of calcite and quartz crystals. Opt. Commun. 163, 95-102 (1999) doi:10.1016/S0030-4018(99)00091-7",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/calcite_o.bin")),
};

/// Calcite, extraordinary ray, 300 to 1000 nm.
///
/// G. Ghosh. Dispersion-equation coefficients for the refractive index and birefringence of calcite and quartz crystals. Opt. Commun. 163, 95-102 (1999) doi:10.1016/S0030-4018(99)00091-7
pub static CALCITE_EXTRAORDINARY_RAY: Material = Material {
    key: "calcite_e",
    name: "Calcite, extraordinary ray",
    kind: Kind::Dielectric,
    citation: "G. Ghosh. Dispersion-equation coefficients for the refractive index and birefringence of calcite and quartz crystals. Opt. Commun. 163, 95-102 (1999) doi:10.1016/S0030-4018(99)00091-7",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; no k in the set, written as 0",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/calcite_e.bin")),
};

/// Rutile, ordinary ray, 430 to 1000 nm.
///
/// Remark: starts at 430 nm.
///
/// J. R. Devore. Refractive indices of rutile and sphalerite. J. Opt. Soc. Am. 41, 416-419 (1951) doi:10.1364/JOSA.41.000416
pub static RUTILE_ORDINARY_RAY: Material = Material {
    key: "TiO2_o",
    name: "Rutile, ordinary ray",
    kind: Kind::Dielectric,
    citation: "J. R. Devore. Refractive indices of rutile and sphalerite. J. Opt. Soc. Am. 41, 416-419 (1951) doi:10.1364/JOSA.41.000416",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 4 evaluated every 5 nm; no k in the set, written as 0",
    remark: Some("starts at 430 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/TiO2_o.bin")),
};

/// Rutile, extraordinary ray, 430 to 1000 nm.
///
/// Remark: starts at 430 nm.
///
/// J. R. Devore. Refractive indices of rutile and sphalerite. J. Opt. Soc. Am. 41, 416-419 (1951) doi:10.1364/JOSA.41.000416
pub static RUTILE_EXTRAORDINARY_RAY: Material = Material {
    key: "TiO2_e",
    name: "Rutile, extraordinary ray",
    kind: Kind::Dielectric,
    citation: "J. R. Devore. Refractive indices of rutile and sphalerite. J. Opt. Soc. Am. 41, 416-419 (1951) doi:10.1364/JOSA.41.000416",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 4 evaluated every 5 nm; no k in the set, written as 0",
    remark: Some("starts at 430 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/TiO2_e.bin")),
};

/// Titanium dioxide thin film (ALD), 298.426 to 1005.39 nm.
///
/// T. Siefke, S. Kroker, K. Pfeiffer, O. Puffky, K. Dietrich, D. Franta, I. Ohlídal, A. Szeghalmi, E.-B. Kley, A. Tünnermann. Materials pushing the application limits of wire grid polarizers further into the deep ultraviolet spectral range. Adv. Opt. Mater. 4, 1780–1786 (2016) doi:10.1002/adom.201600250 (Numerical data kindly provided by Thomas Siefke)
pub static TITANIUM_DIOXIDE_THIN_FILM_ALD: Material = Material {
    key: "TiO2_film",
    name: "Titanium dioxide thin film (ALD)",
    kind: Kind::Dielectric,
    citation: "T. Siefke, S. Kroker, K. Pfeiffer, O. Puffky, K. Dietrich, D. Franta, I. Ohlídal, A. Szeghalmi, E.-B. Kley, A. Tünnermann. Materials pushing the application limits of wire grid polarizers further into the deep ultraviolet spectral range. Adv. Opt. Mater. 4, 1780–1786 (2016) doi:10.1002/adom.201600250 (Numerical data kindly provided by Thomas Siefke)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/TiO2_film.bin")),
};

/// Zinc sulfide, 405 to 1000 nm.
///
/// Remark: starts at 405 nm.
///
/// 1) M. Debenham. Refractive indices of zinc sulfide in the 0.405-13-µm wavelength range. Appl. Opt., 23, 2238-2239 (1984) doi:10.1364/AO.23.002238 2) C. A. Klein. Room-temperature dispersion equations for cubic zinc sulfide. Appl. Opt. 25, 1873-1875 (1986) doi:10.1364/AO.25.001873 \*Ref. 2 provides a modified Sellmeier equation based on data from Ref. 1
pub static ZINC_SULFIDE: Material = Material {
    key: "ZnS",
    name: "Zinc sulfide",
    kind: Kind::Dielectric,
    citation: "1) M. Debenham. Refractive indices of zinc sulfide in the 0.405-13-µm wavelength range. Appl. Opt., 23, 2238-2239 (1984) doi:10.1364/AO.23.002238 2) C. A. Klein. Room-temperature dispersion equations for cubic zinc sulfide. Appl. Opt. 25, 1873-1875 (1986) doi:10.1364/AO.25.001873 *Ref. 2 provides a modified Sellmeier equation based on data from Ref. 1",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 4 evaluated every 5 nm; no k in the set, written as 0",
    remark: Some("starts at 405 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/ZnS.bin")),
};

/// Acrylic (PMMA), 405 to 1000 nm.
///
/// Remark: starts at 405 nm.
///
/// Marcin Szczurowski. Private communications (2013) \[original data\].
pub static ACRYLIC_PMMA: Material = Material {
    key: "PMMA",
    name: "Acrylic (PMMA)",
    kind: Kind::Dielectric,
    citation: "Marcin Szczurowski. Private communications (2013) [original data].",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; no k in the set, written as 0",
    remark: Some("starts at 405 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/PMMA.bin")),
};

/// Acrylic (PMMA), Sultanova 2009, 440 to 1000 nm.
///
/// Remark: starts at 440 nm.
///
/// N. Sultanova, S. Kasarova, I. Nikolov. Dispersion properties of optical polymers. Acta Physica Polonica A 116, 585-587 (2009) (fit of the experimental data with the Sellmeier dispersion formula: Mikhail Polyanskiy)
pub static ACRYLIC_PMMA_SULTANOVA_2009: Material = Material {
    key: "PMMA_sultanova",
    name: "Acrylic (PMMA), Sultanova 2009",
    kind: Kind::Dielectric,
    citation: "N. Sultanova, S. Kasarova, I. Nikolov. Dispersion properties of optical polymers. Acta Physica Polonica A 116, 585-587 (2009) (fit of the experimental data with the Sellmeier dispersion formula: Mikhail Polyanskiy)",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; no k in the set, written as 0",
    remark: Some("starts at 440 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/PMMA_sultanova.bin")),
};

/// Polycarbonate, 400 to 1010 nm.
///
/// Remark: starts at 400 nm.
///
/// 1) X. Zhang, J. Qiu, X. Li, J. Zhao, L. Liu. Complex refractive indices measurements of polymers in visible and near-infrared bands. Appl. Opt. 59, 2337-2344 (2020) doi:10.1364/AO.383831 (0.4-2 µm) 2) X. Zhang, J. Qiu, J. Zhao, X. Li, L. Liu. Complex refractive indices measurements of polymers in infrared bands. J. Quant. Spectrosc. Radiat. Transf. 252, 107063 (2020) doi:10.1016/j.jqsrt.2020.107063 (2-20 µm)
pub static POLYCARBONATE: Material = Material {
    key: "polycarbonate",
    name: "Polycarbonate",
    kind: Kind::Dielectric,
    citation: "1) X. Zhang, J. Qiu, X. Li, J. Zhao, L. Liu. Complex refractive indices measurements of polymers in visible and near-infrared bands. Appl. Opt. 59, 2337-2344 (2020) doi:10.1364/AO.383831 (0.4-2 µm) 2) X. Zhang, J. Qiu, J. Zhao, X. Li, L. Liu. Complex refractive indices measurements of polymers in infrared bands. J. Quant. Spectrosc. Radiat. Transf. 252, 107063 (2020) doi:10.1016/j.jqsrt.2020.107063 (2-20 µm)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: Some("starts at 400 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/polycarbonate.bin")),
};

/// Polycarbonate, Sultanova 2009, 440 to 1000 nm.
///
/// Remark: starts at 440 nm.
///
/// N. Sultanova, S. Kasarova, I. Nikolov. Dispersion properties of optical polymers. Acta Physica Polonica A 116, 585-587 (2009) (fit of the experimental data with the Sellmeier dispersion formula: Mikhail Polyanskiy)
pub static POLYCARBONATE_SULTANOVA_2009: Material = Material {
    key: "polycarbonate_sultanova",
    name: "Polycarbonate, Sultanova 2009",
    kind: Kind::Dielectric,
    citation: "N. Sultanova, S. Kasarova, I. Nikolov. Dispersion properties of optical polymers. Acta Physica Polonica A 116, 585-587 (2009) (fit of the experimental data with the Sellmeier dispersion formula: Mikhail Polyanskiy)",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; no k in the set, written as 0",
    remark: Some("starts at 440 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/polycarbonate_sultanova.bin")),
};

/// Polystyrene, 400 to 1010 nm.
///
/// Remark: starts at 400 nm.
///
/// 1) X. Zhang, J. Qiu, X. Li, J. Zhao, L. Liu. Complex refractive indices measurements of polymers in visible and near-infrared bands. Appl. Opt. 59, 2337-2344 (2020) doi:10.1364/AO.383831 (0.4-2 µm) 2) X. Zhang, J. Qiu, J. Zhao, X. Li, L. Liu. Complex refractive indices measurements of polymers in infrared bands. J. Quant. Spectrosc. Radiat. Transf. 252, 107063 (2020) doi:10.1016/j.jqsrt.2020.107063 (2-20 µm)
pub static POLYSTYRENE: Material = Material {
    key: "polystyrene",
    name: "Polystyrene",
    kind: Kind::Dielectric,
    citation: "1) X. Zhang, J. Qiu, X. Li, J. Zhao, L. Liu. Complex refractive indices measurements of polymers in visible and near-infrared bands. Appl. Opt. 59, 2337-2344 (2020) doi:10.1364/AO.383831 (0.4-2 µm) 2) X. Zhang, J. Qiu, J. Zhao, X. Li, L. Liu. Complex refractive indices measurements of polymers in infrared bands. J. Quant. Spectrosc. Radiat. Transf. 252, 107063 (2020) doi:10.1016/j.jqsrt.2020.107063 (2-20 µm)",
    license: "CC0-1.0",
    form: Form::Table,
    preparation: "original samples",
    remark: Some("starts at 400 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/polystyrene.bin")),
};

/// Polystyrene, Sultanova 2009, 440 to 1000 nm.
///
/// Remark: starts at 440 nm.
///
/// N. Sultanova, S. Kasarova, I. Nikolov. Dispersion properties of optical polymers. Acta Physica Polonica A 116, 585-587 (2009) (fit of the experimental data with the Sellmeier dispersion formula: Mikhail Polyanskiy)
pub static POLYSTYRENE_SULTANOVA_2009: Material = Material {
    key: "polystyrene_sultanova",
    name: "Polystyrene, Sultanova 2009",
    kind: Kind::Dielectric,
    citation: "N. Sultanova, S. Kasarova, I. Nikolov. Dispersion properties of optical polymers. Acta Physica Polonica A 116, 585-587 (2009) (fit of the experimental data with the Sellmeier dispersion formula: Mikhail Polyanskiy)",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; no k in the set, written as 0",
    remark: Some("starts at 440 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/polystyrene_sultanova.bin")),
};

/// Acetone, 400 to 1000 nm.
///
/// Remark: starts at 400 nm.
///
/// H.-J. Chang, N. Munera, C. Lopez-Zelaya, D. Banerjee, G. Beadie, E. W. Van Stryland, D. J. Hagan. Refractive index measurements of liquids from 0.5 to 2 µm using Rayleigh interferometry. Opt. Mater. Express 14, 1253–1267 (2024) doi:10.1364/OME.519907
pub static ACETONE: Material = Material {
    key: "acetone",
    name: "Acetone",
    kind: Kind::Dielectric,
    citation: "H.-J. Chang, N. Munera, C. Lopez-Zelaya, D. Banerjee, G. Beadie, E. W. Van Stryland, D. J. Hagan. Refractive index measurements of liquids from 0.5 to 2 µm using Rayleigh interferometry. Opt. Mater. Express 14, 1253–1267 (2024) doi:10.1364/OME.519907",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 1 evaluated every 5 nm; no k in the set, written as 0",
    remark: Some("starts at 400 nm"),
    constants: OpticalConstants::packed(include_bytes!("samples/acetone.bin")),
};

/// Ethanol, 300 to 1000 nm.
///
/// E. Sani and A. Dell'Oro. Spectral optical constants of ethanol and isopropanol from ultraviolet to far infrared. Opt. Mater. 60, 137-141 (2016) doi:10.1016/j.optmat.2016.06.041
pub static ETHANOL: Material = Material {
    key: "ethanol",
    name: "Ethanol",
    kind: Kind::Dielectric,
    citation: "E. Sani and A. Dell'Oro. Spectral optical constants of ethanol and isopropanol from ultraviolet to far infrared. Opt. Mater. 60, 137-141 (2016) doi:10.1016/j.optmat.2016.06.041",
    license: "CC0-1.0",
    form: Form::Formula,
    preparation: "dispersion formula 2 evaluated every 5 nm; k interpolated from its table",
    remark: None,
    constants: OpticalConstants::packed(include_bytes!("samples/ethanol.bin")),
};

/// All materials: metals, alloys, second opinions on metals, semiconductors, dielectrics.
pub static ALL: [&Material; 74] = [
    &SILVER,
    &ALUMINIUM,
    &GOLD,
    &BERYLLIUM,
    &COBALT,
    &CHROMIUM,
    &COPPER,
    &IRON,
    &MERCURY_LIQUID,
    &POTASSIUM,
    &MAGNESIUM,
    &MANGANESE,
    &MOLYBDENUM,
    &SODIUM,
    &NIOBIUM,
    &NICKEL,
    &LEAD,
    &PALLADIUM,
    &PLATINUM,
    &RHODIUM,
    &TANTALUM,
    &TITANIUM,
    &VANADIUM,
    &TUNGSTEN,
    &ZINC,
    &BRASS_70_CU_30_ZN,
    &RED_BRASS_85_CU_15_ZN,
    &STAINLESS_STEEL_AUSTENITIC,
    &GOLD_SILVER_ALLOY_50_50,
    &SILVER_MCPEAK_2015,
    &ALUMINIUM_MCPEAK_2015,
    &GOLD_MCPEAK_2015,
    &COPPER_MCPEAK_2015,
    &MOLYBDENUM_QUERRY_1987,
    &PLATINUM_TSELIN,
    &CHROMIUM_SYTCHKOVA,
    &TITANIUM_RAKIC_1998_BB,
    &TUNGSTEN_RAKIC_1998_BB,
    &SILICON,
    &GERMANIUM,
    &AIR_STANDARD,
    &WATER_HALE_QUERRY_1973,
    &WATER_20_C_DAIMON_2007,
    &ICE_WARREN_BRANDT_2008,
    &N_BK7_GLASS_SCHOTT,
    &SF11_GLASS_SCHOTT_LEADED,
    &N_SF11_GLASS_SCHOTT,
    &SODA_LIME_WINDOW_GLASS_CLEAR,
    &FUSED_SILICA,
    &QUARTZ_ORDINARY_RAY,
    &QUARTZ_EXTRAORDINARY_RAY,
    &SAPPHIRE_ORDINARY_RAY,
    &SAPPHIRE_EXTRAORDINARY_RAY,
    &DIAMOND_PHILLIP_TAFT_1964,
    &DIAMOND_PETER_1923,
    &SODIUM_CHLORIDE_HALITE,
    &POTASSIUM_CHLORIDE,
    &FLUORITE,
    &MAGNESIUM_FLUORIDE_ORDINARY_RAY,
    &MAGNESIUM_FLUORIDE_EXTRAORDINARY_RAY,
    &CALCITE_ORDINARY_RAY,
    &CALCITE_EXTRAORDINARY_RAY,
    &RUTILE_ORDINARY_RAY,
    &RUTILE_EXTRAORDINARY_RAY,
    &TITANIUM_DIOXIDE_THIN_FILM_ALD,
    &ZINC_SULFIDE,
    &ACRYLIC_PMMA,
    &ACRYLIC_PMMA_SULTANOVA_2009,
    &POLYCARBONATE,
    &POLYCARBONATE_SULTANOVA_2009,
    &POLYSTYRENE,
    &POLYSTYRENE_SULTANOVA_2009,
    &ACETONE,
    &ETHANOL,
];
