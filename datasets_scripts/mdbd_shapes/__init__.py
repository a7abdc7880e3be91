"""Parametric shapes for the demo collection: closed triangle meshes, made with the standard library."""
