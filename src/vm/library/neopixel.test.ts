import { describe, expect, it } from 'vitest';
import { linesOf } from './testing/play';

describe('neopixel', () => {
  it('sends green, red, blue of every LED', () => {
    const sent: number[][] = [];
    const program = `
import neopixel
np = neopixel.NeoPixel(pin15, 3)
np[0] = (1, 2, 3)
np[2] = (255, 0, 9)
np.show()
print(len(np), np[2])
np.fill((5, 6, 7))
np.write()
np.clear()
err(ws2812_write, 5, b'1')
err(np.__setitem__, 5, (1, 2, 3))`;
    const lines = linesOf(program, {}, (bench) => bench.board.wire('P15').onStream((bytes) => sent.push([...bytes])));
    expect(sent).toEqual([
      [2, 1, 3, 0, 0, 0, 0, 255, 9],
      [6, 5, 7, 6, 5, 7, 6, 5, 7],
      [0, 0, 0, 0, 0, 0, 0, 0, 0],
    ]);
    expect(lines).toEqual(['3 (255, 0, 9)', 'TypeError: expecting a pin', 'IndexError: bytearray index out of range']);
  });
});
