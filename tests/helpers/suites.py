"""A suite of a few seconds, for tests that need results of every part."""

from dataclasses import replace

from quadruped_env.evaluation.suite.suite_definition import quick_suite


def tiny_suite():
    """The quick suite with one or two short episodes of each part."""
    quick = quick_suite()
    axes = {name: commands[:1] for name, commands in quick.commands.axes.items()}
    return replace(
        quick,
        commands=replace(quick.commands, points=3, seconds=2.5, axes=axes),
        joystick=replace(quick.joystick, num_seeds=1, seconds=10.0),
        gait=replace(quick.gait, seconds=3.0),
        transients=replace(quick.transients, before=1.5, after=2.0, changes=quick.transients.changes[1:2]),
        pushes=replace(
            quick.pushes,
            num_seeds=1,
            commands=((0.3, 0.0), (0.0, 0.0)),
            before=(1.5, 2.0),
            after=2.5,
        ),
        regulation=replace(quick.regulation, seconds=2.5, together_seconds=2.5, commands=((0.3, 0.0),)),
        terrain=replace(quick.terrain, levels=1, num_seeds=1, seconds=2.0),
    )
