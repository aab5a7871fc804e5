//! Prints.
use brdf::description::BrdfDescription;
use brdf::wgsl::Module;
use brdf_shaders::validate::validate;

#[test]
fn print() {
    for (index, row) in brdf_checks::models::rows().iter().enumerate() {
        let mut module = Module::new();
        module.add_described("model", &row.brdf).unwrap();
        module.add_albedo("model").unwrap();
        let text = module.to_string();
        std::fs::write(format!("/tmp/wgsl/{index:02}.wgsl"), format!("// {}\n{text}", row.name)).unwrap();
        println!("{index:02} {:50} {:6} bytes {:4} lines", row.name, text.len(), text.lines().count());
        validate(&row.name, &text);
    }
    let _: Option<BrdfDescription> = None;
}
