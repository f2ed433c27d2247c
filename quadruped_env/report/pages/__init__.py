"""HTML reports of one policy, of several policies, and of replays."""
