"""Set parameters of a node, one after the other: prints a JSON object of the reasons for refusal, empty on success."""

import json
import sys

import rclpy
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient

name, values = sys.argv[1], json.loads(sys.argv[2])
rclpy.init()
node = rclpy.create_node("set_parameters")
client = AsyncParameterClient(node, name)
while not client.wait_for_services(timeout_sec=0.5):
    pass
reasons = {}
for parameter, value in values.items():
    future = client.set_parameters([Parameter(parameter, value=value)])
    rclpy.spin_until_future_complete(node, future)
    reasons[parameter] = future.result().results[0].reason
print(json.dumps(reasons))
rclpy.shutdown()
