import { describe, expect, it } from 'vitest';
import { Recording } from '../../../session/run/recording';
import { PrintedSource } from './printed-source';

/** The printed curves of a device: name, then times in ms with values. */
function curves(device: number, ...outputs: readonly (readonly [timeMs: number, text: string, device?: number])[]) {
  const recording = new Recording(null);
  const source = new PrintedSource(() => '', () => recording, device, (place) => `Ausgabe ${place}`); // prettier-ignore
  for (const [timeMs, text, from = 0] of outputs) {
    recording.addOutput({ device: from, text, timeUs: timeMs * 1000 });
    source.update();
  }
  return source.list().map(({ id, name }) => {
    const { timesS, values } = source.pointsOf(id);
    return [name, ...timesS.map((timeS, at) => [timeS * 1000, values[at]])];
  });
}

describe('numbers that a program prints', () => {
  it('are a curve each, at the time at which their line begins', () =>
    expect(curves(0, [20, 'Abstand: 2'], [24, '3 cm\r\n'], [40, 'Abstand: 22 cm\r\n'])).toEqual([
      ['Abstand', [20, 23], [40, 22]],
    ])); // prettier-ignore

  it('have the place in the line for a name where they have none', () =>
    expect(curves(0, [20, '(1, 2)\n'], [40, '5\n'])).toEqual([
      ['Ausgabe 1', [20, 1]],
      ['Ausgabe 2', [20, 2]],
      ['Ausgabe 0', [40, 5]],
    ]));

  it('are those of one device', () => expect(curves(1, [20, '1\n'], [20, '2\n', 1])).toEqual([['Ausgabe 0', [20, 2]]]));

  it('count once at one time: the last one', () => expect(curves(0, [20, '1\n2\n'])).toEqual([['Ausgabe 0', [20, 2]]]));

  it('are not of a line that has not ended', () =>
    expect(curves(0, [20, '1\n'], [30, '2'])).toEqual([['Ausgabe 0', [20, 1]]]));

  it('go on when the oldest output is gone', () => {
    const recording = new Recording(null);
    const source = new PrintedSource(() => '', () => recording, 0, String); // prettier-ignore
    for (let at = 0; at < 60_000; at++) {
      recording.addOutput({ device: 0, text: `${at}\n`, timeUs: at * 20_000 });
      if (at % 100 === 0) source.update();
    }
    source.update();
    expect(source.pointsOf('printed 0').values).toHaveLength(60_000);
    expect(recording.output.length).toBeLessThanOrEqual(40_000);
  });
});
