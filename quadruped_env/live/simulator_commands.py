"""`/reset`, `/pause` and `/step`: commands to simulator and controller."""

from typing import Any, Final

from quadruped_env.live.middleware.node import Subscription
from quadruped_env.live.middleware.topics import PAUSE, RESET, STEP
from quadruped_env.live.session import Session


class SimulatorCommands:
    """The received commands.

    Args:
        session: the session of this process.
        steps: True for a simulator, which performs single steps.
    """

    def __init__(self, session: Session, steps: bool = False) -> None:
        self._session = session
        self.subscriptions: Final[dict[str, Subscription[Any]]] = {
            topic.name: session.node.subscribe(topic) for topic in (RESET, PAUSE, *[STEP] * steps)
        }
        self.paused = False
        self.reset = False
        """True if a reset has come with the last `take`."""
        self.steps = 0
        """Number of single steps that came with the last `take`."""

    def take(self) -> None:
        """Take all messages since the last call."""
        messages = {
            name: [message for _, message in subscription.messages(self._session.refuse)]
            for name, subscription in self.subscriptions.items()
        }
        self.reset, self.steps = bool(messages[RESET.name]), len(messages.get(STEP.name, ()))
        if self.reset:
            self._session.say(f"{RESET.name}: starts again")
        paused = self.paused
        for message in messages[PAUSE.name]:
            self.paused = message.data
        if self.paused != paused:
            self._session.say("paused" if self.paused else "continues after the pause")
