"""Search for the parameters of the scripted gaits, on any robot with a hip and a knee per leg."""
