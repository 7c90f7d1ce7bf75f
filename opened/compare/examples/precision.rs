#![allow(missing_docs, unreachable_pub, unused)]
//! x
macro_rules! study { ($name:ident, $ours:ident, $dim:expr) => {
mod $name {
    use unisize_scenes::$ours::{Scene, rapier::prelude::*};
    use unisize_scenes::$ours::rapier;
    use unisize_scenes::SceneKind;
    use rapier::parry::query;
    type V = [f64; $dim];
    struct Z { c: V, r: f64, ax: Vec<V>, own: Vec<V>, ok: bool }
    fn v(x: rapier::math::Vector) -> V { let a: [f32; $dim] = x.into(); a.map(|x| x as f64) }
    fn dot(a: &V, b: &V) -> f64 { (0..$dim).map(|i| a[i]*b[i]).sum() }
    fn sub(a: &V, b: &V) -> V { std::array::from_fn(|i| a[i]-b[i]) }
    fn len(a: &V) -> f64 { dot(a,a).sqrt() }
    fn z(co: &Collider, pred: f64) -> Z {
        let pose = co.position(); let s = co.shape();
        let extra = pred/2.0 + co.contact_skin() as f64;
        let unit = |i: usize| { let mut e=[0.0f32;$dim]; e[i]=1.0; v(pose.rotation * rapier::math::Vector::from(e)) };
        if let Some(b) = s.as_ball() { return Z{c: v(pose.translation), r: b.radius as f64+extra, ax: vec![], own: vec![], ok: true}; }
        if let Some(b) = s.as_capsule() {
            let a = v(*pose * b.segment.a); let e = v(*pose * b.segment.b);
            return Z{c: std::array::from_fn(|i|(a[i]+e[i])/2.0), r: b.radius as f64+extra, ax: vec![std::array::from_fn(|i|(e[i]-a[i])/2.0)], own: vec![], ok:true};
        }
        let bb = s.compute_local_aabb();
        let (mins,maxs)=(v(bb.mins),v(bb.maxs));
        let ok = mins.iter().chain(&maxs).all(|x| x.abs()<1e6) && !matches!(s.shape_type(), ShapeType::HeightField|ShapeType::TriMesh|ShapeType::HalfSpace|ShapeType::Voxels);
        let c0: V = std::array::from_fn(|i| (mins[i]+maxs[i])/2.0);
        let cc: [f32;$dim] = c0.map(|x| x as f32);
        let c = v(*pose * rapier::math::Vector::from(cc));
        let own: Vec<V> = (0..$dim).map(unit).collect();
        let ax = (0..$dim).map(|i| { let h=(maxs[i]-mins[i])/2.0; own[i].map(|x| x*h) }).collect();
        Z{c, r: extra, ax, own, ok}
    }
    fn apart(a: &Z, b: &Z, n: &V) -> bool {
        let l = len(n); if l < 1e-9 { return false; }
        let h = |z: &Z| z.r*l + z.ax.iter().map(|x| dot(x,n).abs()).sum::<f64>();
        dot(&sub(&b.c,&a.c), n).abs() > h(a)+h(b)
    }
    fn dirs(k: usize) -> Vec<V> {
        let mut out = vec![];
        let total = 3usize.pow($dim);
        for i in 0..total { let mut j=i; let d: V = std::array::from_fn(|_| { let x = (j%3) as f64-1.0; j/=3; x });
            let nz = d.iter().filter(|x| **x!=0.0).count();
            if d.iter().find(|x| **x!=0.0).is_some_and(|x| *x>0.0) && nz==k { out.push(d); } }
        out
    }
    pub(crate) fn run(kind: SceneKind, bodies: usize, steps: usize) {
        let mut scene = Scene::build(kind, bodies, 1);
        let mut bp = DefaultBroadPhase::new();
        let mut n = [0usize; 12];
        for step in 0..steps {
            scene.prepare();
            scene.world.step(&mut bp, &(), &());
            if step < steps/2 || step % 10 != 9 { continue; }
            let pred = scene.world.params.prediction_distance() as f64;
            let (d2, d3) = (dirs(2), dirs(3));
            let world: Vec<V> = dirs(1);
            for pair in scene.world.narrow_phase.contact_pairs() {
                let (a,b)=(&scene.world.colliders[pair.collider1], &scene.world.colliders[pair.collider2]);
                n[0]+=1;
                let contact = pair.has_any_active_contact();
                n[1]+=contact as usize;
                let near = query::distance(a.position(), a.shape(), b.position(), b.shape()).map_or(true, |d| d.distance as f64 <= pred + 1e-6 + (a.contact_skin()+b.contact_skin()) as f64);
                n[2]+=near as usize;
                let (za,zb)=(z(a,pred),z(b,pred));
                let known = za.ok && zb.ok;
                let tight = !a.compute_collision_aabb(pred as f32/2.0).intersects(&b.compute_collision_aabb(pred as f32/2.0));
                let _ = &world;
                let centre = known && apart(&za,&zb,&sub(&zb.c,&za.c));
                let o2 = known && d2.iter().any(|d| apart(&za,&zb,d));
                let o3 = known && d3.iter().any(|d| apart(&za,&zb,d));
                let own = known && za.own.iter().chain(&zb.own).any(|d| apart(&za,&zb,d));
                let keep = |x: bool| (!tight && !x) as usize;
                n[3]+= keep(false);
                n[4]+= keep(centre);
                n[5]+= keep(o3);
                n[6]+= keep(o2);
                n[7]+= keep(o2||o3);
                n[8]+= keep(own);
                n[9]+= keep(own||centre);
                n[10]+= keep(!near && known);
                n[11]+= keep(!near);
            }
        }
        let s = n.map(|x| x as f64 / n[1].max(1) as f64);
        println!("{:14} {}D contacts {:7} | per contact: held {:5.2} near {:5.2} tight {:5.2} centre {:5.2} dop+corners {:5.2} +edges {:5.2} +both {:5.2} own {:5.2} own+centre {:5.2} exact(known) {:5.2} exact {:5.2}", kind.name(), $dim, n[1], s[0], s[2], s[3], s[4], s[5], s[6], s[7], s[8], s[9], s[10], s[11]);
    }
}}}
use unisize_scenes::SceneKind as K;
study!(s2, dim2_0_36, 2);
study!(s3, dim3_0_36, 3);
fn main() {
    for (k, n) in [
        (K::FallingBalls, 2000),
        (K::Gas, 4000),
        (K::Ropes, 1000),
        (K::Hopper, 1000),
        (K::Net, 1000),
        (K::Pyramid, 1000),
        (K::MixedOneAndAHalf, 2000),
        (K::MixedFour, 1000),
        (K::Shapes, 1000),
        (K::Soft, 500),
        (K::Bullets, 500),
        (K::Churn, 1000),
    ] {
        s2::run(k, n, 150);
        s3::run(k, n, 150);
    }
}
