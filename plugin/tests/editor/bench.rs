//! An editor on a bench: parameters, a link, a host, and an engine to look at.

use crate::host::Host;
use egui_kittest::Harness;
use idiophone::editor::{Link, Saved, Touch, Ui};
use idiophone::engine::{Engine, Vectors};
use idiophone::factory;
use idiophone::params::Controls;
use idiophone::shelf::OWN;
use nice_plug::prelude::{ParamPtr, ParamSetter, Params as _};
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

/// Number of the instrument of that name.
fn index(name: &str) -> usize {
    let found = factory::BANKS.iter().position(|(other, _)| *other == name);
    found.expect("there is such an instrument")
}

/// Everything around an editor.
pub(crate) struct Bench {
    pub(crate) controls: Arc<Controls>,
    pub(crate) saved: Arc<Saved>,
    pub(crate) link: Arc<Link>,
    pub(crate) host: Rc<Host>,
    pub(crate) ui: Rc<RefCell<Ui>>,
}

impl Bench {
    /// A new instance, on the instrument of that name.
    pub(crate) fn new(instrument: &str) -> Self {
        let instrument = index(instrument);
        let controls = Arc::new(Controls::default());
        let (saved, link) = (Arc::new(Saved::default()), Arc::new(Link::default()));
        let mut ui = Ui::new(Arc::clone(&controls), Arc::clone(&saved), Arc::clone(&link));
        // No test reads or writes what is the user's.
        ui.keep_presets_in(None);
        let bench = Self {
            controls,
            saved,
            link,
            host: Rc::default(),
            ui: Rc::new(RefCell::new(ui)),
        };
        bench.set("instr", instrument as f32 / OWN as f32);
        bench
    }

    /// Another window of the same instance.
    pub(crate) fn reopen(&self) {
        // The old one first puts down what is to outlive it.
        let spare = (Arc::default(), Arc::default(), Arc::default());
        self.ui.replace(Ui::new(spare.0, spare.1, spare.2));
        let (controls, saved, link) = (&self.controls, &self.saved, &self.link);
        let mut ui = Ui::new(Arc::clone(controls), Arc::clone(saved), Arc::clone(link));
        ui.keep_presets_in(None);
        self.ui.replace(ui);
    }

    fn pointer(&self, id: &str) -> ParamPtr {
        let map = self.controls.param_map();
        let found = map.into_iter().find(|(other, _, _)| other == id);
        found.expect("there is such a parameter").1
    }

    /// Puts a parameter at a place 0…1, as automation does.
    pub(crate) fn set(&self, id: &str, value: f32) {
        let pointer = self.pointer(id);
        // SAFETY: the controls are alive.
        #[expect(unsafe_code, reason = "the framework hands out raw pointers")]
        unsafe {
            pointer._internal_set_normalized_value(value);
        }
    }

    /// Where a parameter is, 0…1, and where it is in a new instance.
    pub(crate) fn value(&self, id: &str) -> (f32, f32) {
        let pointer = self.pointer(id);
        // SAFETY: the controls are alive.
        #[expect(unsafe_code, reason = "the framework hands out raw pointers")]
        unsafe {
            (
                pointer.unmodulated_normalized_value(),
                pointer.default_normalized_value(),
            )
        }
    }

    /// What a parameter is, for people.
    pub(crate) fn text(&self, id: &str) -> String {
        let pointer = self.pointer(id);
        // SAFETY: the controls are alive.
        #[expect(unsafe_code, reason = "the framework hands out raw pointers")]
        unsafe {
            pointer.normalized_value_to_string(pointer.unmodulated_normalized_value(), true)
        }
    }

    /// The touches that have come.
    pub(crate) fn touches(&self) -> Vec<Touch> {
        self.link.touches().collect()
    }

    /// Lets the editor see an instrument on which some keys have been struck with some velocities one
    /// after the other, `each_s` apart.
    pub(crate) fn ring(&self, instrument: &str, blows: &[(u8, f32)], each_s: f64) {
        let instrument = index(instrument);
        let mut engine = Engine::with_vectors(factory::bank(instrument), 48e3, Vectors::Plain);
        engine.set(&self.controls.settings());
        engine.set_trims(&self.controls.trims().get());
        let frames = (48e3 * each_s) as usize;
        let (mut left, mut right) = (vec![0.0; frames], vec![0.0; frames]);
        for (key, velocity) in blows {
            assert!(engine.strike(*key, *velocity), "there is a body for {key}");
            engine.process(&mut left, &mut right);
            self.link.hear(&left, &right);
        }
        let peak = |samples: &[f32]| samples.iter().fold(0.0f32, |most, x| most.max(x.abs()));
        let peaks = [peak(&left), peak(&right)];
        self.link
            .show(|frame| frame.fill(instrument, &engine, peaks));
    }

    /// The editor in a harness, of the usual size.
    pub(crate) fn harness(&self) -> Harness<'static> {
        let (ui, host) = (Rc::clone(&self.ui), Rc::clone(&self.host));
        Harness::builder()
            .with_size(egui::vec2(1000.0, 680.0))
            .with_step_dt(1.0 / 60.0)
            .build_ui(move |target| {
                let setter = ParamSetter::new(&*host);
                ui.borrow_mut().show(target, &setter);
            })
    }
}

/// The strike position of a new instance, 0…1.
pub(crate) fn usual_position() -> f32 {
    Controls::default().strike.position.value() / 100.0
}
