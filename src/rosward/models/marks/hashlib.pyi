# SPDX-License-Identifier: Apache-2.0
"""hashlib: digests; an object keeps what it is updated with."""

from _rosward import changes, pure

pure(__name__)

class md5:
    @changes("self")
    def update(self, data): ...
class sha1:
    @changes("self")
    def update(self, data): ...
class sha224:
    @changes("self")
    def update(self, data): ...
class sha256:
    @changes("self")
    def update(self, data): ...
class sha384:
    @changes("self")
    def update(self, data): ...
class sha512:
    @changes("self")
    def update(self, data): ...
class blake2b:
    @changes("self")
    def update(self, data): ...
class blake2s:
    @changes("self")
    def update(self, data): ...
class sha3_224:
    @changes("self")
    def update(self, data): ...
class sha3_256:
    @changes("self")
    def update(self, data): ...
class sha3_384:
    @changes("self")
    def update(self, data): ...
class sha3_512:
    @changes("self")
    def update(self, data): ...
class shake_128:
    @changes("self")
    def update(self, data): ...
class shake_256:
    @changes("self")
    def update(self, data): ...
class new:
    @changes("self")
    def update(self, data): ...
