"""Program: a Ray cluster of two nodes on this machine, on loopback. Prints its address; a line on stdin kills a node.

It ends, with all of the cluster's processes, when its standard input ends.
"""

import sys

from ray.cluster_utils import Cluster

if __name__ == "__main__":
    cluster = Cluster()
    try:
        nodes = [
            cluster.add_node(
                num_cpus=1, include_dashboard=False, object_store_memory=80 * 2**20, node_ip_address="127.0.0.1"
            )
            for _ in range(2)
        ]
        print(cluster.address, flush=True)
        for _ in sys.stdin:
            cluster.remove_node(nodes.pop(), allow_graceful=False)
            print("killed", flush=True)
    finally:
        cluster.shutdown()
