"""Parametric shapes for the demo collection: closed triangle meshes."""
