"""An rclpy subscriber of /joint_states: prints a number of messages, one JSON document per line."""

import json
import sys

import rclpy
from sensor_msgs.msg import JointState

count = int(sys.argv[1])
received = []
rclpy.init()
node = rclpy.create_node("print_joint_states")
subscription = node.create_subscription(JointState, "/joint_states", received.append, 1000)
while len(received) < count:
    rclpy.spin_once(node, timeout_sec=0.1)
for message in received[:count]:
    stamp = message.header.stamp
    document = {
        "timestamp": stamp.sec * 1_000_000_000 + stamp.nanosec,
        "name": list(message.name),
        "position": list(message.position),
        "velocity": list(message.velocity),
        "effort": list(message.effort),
    }
    print(json.dumps(document))
