use brdf::{BlinnPhong, ClassicPhong, Phong, Real, SchlickPower};

use super::{Entries, Entry, lit, rgb};

pub(super) fn entries<T: Real>() -> Entries<T> {
    let lit = lit::<T>;
    let color = || rgb::<T>(1.0, 0.9, 0.8);
    Ok(vec![
        Entry::new("Phong 0", Phong::new(color(), lit(0.0))?),
        Entry::new("Phong 10", Phong::new(color(), lit(10.0))?),
        Entry::new("Phong 2000", Phong::new(color(), lit(2000.0))?),
        Entry::new("Phong 1e5", Phong::new(color(), lit(1e5))?),
        Entry::new("classic Phong 3", ClassicPhong::new(color(), lit(3.0))?)
            .not_reciprocal()
            .gains(std::f64::consts::FRAC_PI_2, 0.0),
        Entry::new("classic Phong 60", ClassicPhong::new(color(), lit(60.0))?).not_reciprocal(),
        Entry::new("Blinn-Phong 0", BlinnPhong::new(color(), lit(0.0))?),
        Entry::new("Blinn-Phong 1.5", BlinnPhong::new(color(), lit(1.5))?),
        Entry::new("Blinn-Phong 40", BlinnPhong::new(color(), lit(40.0))?),
        Entry::new("Blinn-Phong 1e5", BlinnPhong::new(color(), lit(1e5))?),
        Entry::new("unnormalised Blinn-Phong 5", BlinnPhong::unnormalized(color(), lit(5.0))?)
            .gains(2.06518, 0.0),
        Entry::new("Schlick's power 1", SchlickPower::new(color(), lit(1.0))?),
        Entry::new("Schlick's power 10", SchlickPower::new(color(), lit(10.0))?),
        Entry::new("Schlick's power 1000", SchlickPower::new(color(), lit(1000.0))?),
        Entry::new("Schlick's power 1e5", SchlickPower::new(color(), lit(1e5))?),
        Entry::new(
            "unnormalised Schlick's power 2",
            SchlickPower::unnormalized(color(), lit(2.0))?,
        )
        .gains(1.71273, 0.0),
    ])
}
