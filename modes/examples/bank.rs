//! probe
use modes::*; use modes::factory::*;
fn main(){ let (n,t)=Recipe::FACTORY[0]; let mut t=t.to_string(); if let Some(a)=std::env::args().nth(1){t=t.replace("high = 96", &format!("high = {a}"));} let r=Recipe::parse(&t,n).unwrap(); let t=std::time::Instant::now(); let b=build(&r,&Silent).unwrap(); println!("{:?} modes {} bytes {}", t.elapsed(), b.bodies.iter().map(|b|b.modes.len()).sum::<usize>(), b.write().len());
 println!("{:?}", (b.provenance.max_residual,b.provenance.max_orthonormality_error));
 for b in &b.bodies { println!("{} {:.4} m modes {} points {} f1 {:.4} cents {:.5} top {}", b.key,b.length_m,b.modes.len(),b.line.len(), b.modes.iter().find(|m|m.label.family==Family::Bending).unwrap().hz, 1200.0*(b.modes.iter().find(|m|m.label.family==Family::Bending).unwrap().hz/b.pitch_hz).log2(), b.modes.last().unwrap().label); if b.key==74 {for m in b.modes.iter().take(30) {println!("  {} {:.3} {:.3e} {:.1e}",m.label,m.hz,m.coupling,m.residual)}} }
}
