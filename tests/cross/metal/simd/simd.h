// What the texts include beside metal_stdlib; it adds nothing to it.
