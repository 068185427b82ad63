// Provisional: the layer has no source yet.
