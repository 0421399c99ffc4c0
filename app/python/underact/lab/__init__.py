"""Pictures of what `underact-cli lab` measures, from its tables (CSV)."""
