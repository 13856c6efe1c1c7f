"""Symbolic derivation of the equations of motion, written out as committed TypeScript."""
