//! A lifted model says in every lane what the model says.

use brdf::{
    Beckmann, Blinn, Blinn1977, Blinn1977Printed, BlinnPhong, Brdf, ClassicPhong, Conductor,
    Constant, Cook, CookTorrance, CookTorrance1982Printed, Dielectric, Gaussian, Ggx, Hall,
    Lambert, Lanes, Lift, Mixture, OrenNayar, ParameterError, Phong, Schlick, SchlickPower,
    SmithCorrelated, SmithSeparable, Vector3, WeightedSum,
};
use brdf_checks::directions::pairs;
use glam::DVec3;

type Pair = Lanes<f64, 2>;

fn check<M>(model: &M)
where
    M: Brdf<f64, Color = DVec3> + Lift<f64>,
    M::Over<Pair>: Brdf<Pair, Color = Vector3<Pair>>,
{
    let lanes = model.lift(|parameter| Lanes([parameter; 2]));
    for chunk in pairs(64).chunks_exact(2) {
        let gather = |at: fn(&(DVec3, DVec3)) -> DVec3| {
            let [first, second] = [at(&chunk[0]), at(&chunk[1])];
            Vector3 {
                x: Lanes([first.x, second.x]),
                y: Lanes([first.y, second.y]),
                z: Lanes([first.z, second.z]),
            }
        };
        let value = lanes.eval(gather(|pair| pair.0), gather(|pair| pair.1));
        let sample = lanes.sample(gather(|pair| pair.1), [Lanes([0.3, 0.8]), Lanes([0.6, 0.1])]);
        for (lane, (wi, wo)) in chunk.iter().enumerate() {
            let name = std::any::type_name::<M>();
            let value = DVec3::new(value.x.0[lane], value.y.0[lane], value.z.0[lane]);
            assert_eq!(value, model.eval(*wi, *wo), "{name}");
            let want = model.sample(*wo, [[0.3, 0.6], [0.8, 0.1]][lane]);
            assert_eq!(sample.pdf.0[lane], want.pdf, "{name}");
            assert_eq!(sample.wi.x.0[lane], want.wi.x, "{name}");
        }
    }
}

#[test]
fn every_kind_of_model_can_be_lifted() -> Result<(), ParameterError> {
    let rgb = DVec3::new(0.9, 0.5, 0.2);
    let gold = Conductor::new(DVec3::new(0.143, 0.374, 1.442), DVec3::new(3.983, 2.386, 1.603))?;
    let blinn_1977 = Blinn1977::new(0.3)?;
    check(&Lambert::new(rgb)?);
    check(&OrenNayar::with_interreflection(rgb, 0.4)?);
    check(&Phong::new(rgb, 20.0)?);
    check(&ClassicPhong::new(rgb, 20.0)?);
    check(&BlinnPhong::new(rgb, 20.0)?);
    check(&SchlickPower::new(rgb, 20.0)?);
    check(&CookTorrance::new(Gaussian::new(0.3)?, gold));
    check(&CookTorrance::new(Blinn::new(20.0)?, Constant::new(rgb)?));
    check(
        &CookTorrance::new(Beckmann::anisotropic(0.2, 0.4)?, Dielectric::new(DVec3::splat(1.5))?)
            .with_shadowing(SmithCorrelated),
    );
    let mixture = Mixture::new([(0.4, Ggx::new(0.2)?), (0.6, Ggx::anisotropic(0.5, 0.1)?)])?;
    check(&CookTorrance::new(mixture, Hall::new(rgb, 1.5)?).with_shadowing(SmithSeparable));
    check(&CookTorrance::new(Ggx::new(0.3)?, Cook::new(rgb, rgb, 1.5)?));
    check(&CookTorrance1982Printed::new(Beckmann::new(0.3)?, Schlick::new(rgb)?));
    check(&Blinn1977Printed::d2(blinn_1977, gold)?);
    check(&WeightedSum::new([(rgb, Phong::new(rgb, 3.0)?), (rgb, Phong::new(rgb, 90.0)?)])?);
    Ok(())
}
