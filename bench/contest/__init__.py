"""rimroll against its peers: who takes part, on which starts, in rounds; tables and figures."""
