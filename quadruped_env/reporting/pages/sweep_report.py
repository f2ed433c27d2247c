def write_sweep_report(path, results): return path
