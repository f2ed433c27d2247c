"""The robot on live ROS 2 topics, over DDS and without a ROS installation: `mini-quadruped live NODE`.

`Node` has publishers and subscriptions; `topics` names this robot's topics; `nodes` are the programs. Needs the extras
`dds` and `ros`.
"""

from quadruped_env.live.middleware.dds import Network
from quadruped_env.live.middleware.node import Node, Publisher, Received, Subscription
from quadruped_env.live.middleware.ros_graph import Endpoint, Graph
from quadruped_env.live.middleware.topics import TOPICS, Topic
from quadruped_env.live.session import Session, add_common_arguments

__all__ = [
    "TOPICS",
    "Endpoint",
    "Graph",
    "Network",
    "Node",
    "Publisher",
    "Received",
    "Session",
    "Subscription",
    "Topic",
    "add_common_arguments",
]
