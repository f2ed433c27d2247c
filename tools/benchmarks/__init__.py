"""The code of the tools: measurements of speed, memory and accuracy, and the acceptance of the shipped policy."""
