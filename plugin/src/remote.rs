//! Pages of eight controls for hosts' remote surfaces.

use crate::params::Controls;
use nice_plug::prelude::{RemoteControlsContext, RemoteControlsPage, RemoteControlsSection};

/// Tells the host which parameters lie together under a player's hands.
pub(crate) fn pages(controls: &Controls, context: &mut impl RemoteControlsContext) {
    let Controls {
        body,
        strike,
        mallet,
        bow,
        damping,
        motor,
        listener,
        hands,
        assign,
        output,
        shape,
        ..
    } = controls;
    context.add_section("Instrument", |section| {
        section.add_page("Play", |page| {
            page.add_param(&body.instrument);
            page.add_param(&strike.position);
            page.add_param(&mallet.mallet);
            page.add_param(&mallet.hardness);
            page.add_param(&damping.alpha1);
            page.add_param(&damping.alpha2);
            page.add_param(&damping.note_off);
            page.add_param(&output.gain);
        });
        section.add_page("Strike", |page| {
            page.add_param(&strike.position);
            page.add_param(&strike.across);
            page.add_param(&strike.from_velocity);
            page.add_param(&strike.scatter);
            page.add_param(&strike.velocity_range);
            page.add_param(&strike.speed_scatter);
            page.add_param(&hands.velocity_curve);
        });
        section.add_page("Mallet", |page| {
            page.add_param(&mallet.mallet);
            page.add_param(&mallet.mass);
            page.add_param(&mallet.radius);
            page.add_param(&mallet.hardness);
            page.add_param(&mallet.loss);
            page.add_param(&mallet.roughness);
            page.add_param(&mallet.dead_stroke);
        });
        section.add_page("Bow", |page| {
            page.add_param(&bow.keys);
            page.add_param(&bow.force);
            page.add_param(&bow.speed);
        });
    });
    context.add_section("Sound", |section| {
        section.add_page("Damping", |page| {
            page.add_param(&damping.alpha1);
            page.add_param(&damping.alpha2);
            page.add_param(&damping.own);
            page.add_param(&damping.loss_factor);
            page.add_param(&damping.radiation);
            page.add_param(&damping.supports);
            page.add_param(&damping.note_off);
        });
        section.add_page("Body", |page| {
            page.add_param(&body.size);
            page.add_param(&body.stiffness);
            page.add_param(&body.density);
            page.add_param(&body.swing);
            page.add_param(&body.sympathy);
        });
        section.add_page("Shape", |page| {
            page.add_param(&shape.length);
            page.add_param(&shape.wall);
            page.add_param(&shape.breadth);
            page.add_param(&shape.profile);
            page.add_param(&shape.poisson);
        });
        section.add_page("Motor and listener", |page| {
            page.add_param(&motor.speed);
            page.add_param(&motor.depth);
            page.add_param(&motor.phase);
            page.add_param(&listener.width);
            page.add_param(&listener.distance);
            page.add_param(&listener.angle);
        });
        section.add_page("Output", |page| {
            page.add_param(&output.gain);
            page.add_param(&output.limiter);
            page.add_param(&output.outputs);
        });
    });
    context.add_section("Hands", |section| {
        section.add_page("Hands", |page| {
            page.add_param(&hands.velocity_curve);
            page.add_param(&hands.bend_range);
            page.add_param(&hands.mpe);
            page.add_param(&hands.mpe_bend_range);
        });
        for (first, pair) in (1..).step_by(2).zip(assign.chunks(2)) {
            let name = format!("Assign {first} and {}", first + 1);
            section.add_page(name, |page| {
                for slot in pair {
                    page.add_param(&slot.source);
                    page.add_param(&slot.target);
                    page.add_param(&slot.depth);
                    page.add_param(&slot.curve);
                }
            });
        }
    });
}
