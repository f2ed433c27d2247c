"""What tests of the viewer share: looks at its robots."""

DT = 0.02


def robot(controller, index=0):
    return controller._slots[index].robot


def now(controller, index=0):
    return controller.view().robots[index].now


def throw_on_the_back(controller):
    data = robot(controller).data
    data.qpos[2:7] = [0.1, 0.0, 1.0, 0.0, 0.0]
