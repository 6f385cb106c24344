# How deep calls of many kinds may go. Run in Node and in the browsers' workers: the limit must be the same everywhere.
def plain(n):
    return 1 + plain(n - 1) if n else 0
class Box:
    def method(self, n): return self.method(n - 1) if n else 0
def listed(n):
    return [listed(n - 1) for _ in range(1)] if n else 0
def mapped(n):
    return list(map(mapped, [n - 1])) if n else 0
def guarded(n):
    try:
        return guarded(n - 1) if n else 0
    finally:
        pass
def generated(n):
    if n:
        yield from generated(n - 1)
    yield n
def starred(*args, **kwargs):
    return starred(*args, n=kwargs['n'] - 1) if kwargs['n'] else 0
def limit(call):
    n = 1
    try:
        while True:
            call(n)
            n += 1
    except RuntimeError as error:
        return n
print('plain', limit(plain))
print('method', limit(Box().method))
print('listed', limit(listed))
print('guarded', limit(guarded))
print('mapped', limit(mapped))
print('generated', limit(lambda n: list(generated(n))))
print('starred', limit(lambda n: starred(n=n)))
