"""Code that many parts share: files, documents, provenance, rotations, arrays, and this machine's Python and OpenGL."""
