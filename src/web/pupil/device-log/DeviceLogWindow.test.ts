// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import type { DeviceLog } from '#device-log/device-log';
import { readDeviceLog } from '#device-log/read-device-log';
import { microbitPage } from '#device-log/testing/microbit-page';

import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import DeviceLogRow from './DeviceLogRow.vue';
import DeviceLogWindow from './DeviceLogWindow.vue';

function logOf(bytes: Uint8Array): DeviceLog {
  const read = readDeviceLog(bytes);
  if (read.kind === 'problem') throw new Error(read.problem.code);
  return read.log;
}
const csv = 'Time (seconds),cm,light\n0.10,12.5,3\n0.20,nan,4\n0.30,11,5\n';

let page: TestPage;
beforeEach(() => {
  page = createPage();
  page.dataLog.device.value = { file: 'MY_DATA.HTM', log: logOf(microbitPage({ csv, isFull: true })) };
});
const logged = (...values: readonly string[]) => ({
  ...{ type: 'row' as const, headings: ['Time (seconds)', 'cm', 'temp'], values, timeUs: 0 },
});
const all = (css: string): readonly Element[] => [...document.querySelectorAll(css)];
const labels = () => all('.charts svg').map((it) => it.getAttribute('aria-label'));

describe('the window of a device’s readings', () => {
  it('has a chart for each column, with the simulation’s curve of the same name in it', () => {
    page.dataLog.take([logged('0.10', '13', '20'), logged('0.20', '14', '20')]);
    mountOn(page, DeviceLogWindow);
    expect(labels()).toEqual([
      'cm. Gerät: 2 Werte von 11 bis 12.5. Simulation: 2 Werte von 13 bis 14',
      'light. Gerät: 3 Werte von 3 bis 5',
      'temp. Simulation: 2 Werte von 20 bis 20',
    ]);
    const [cm] = all('.charts svg');
    // The device's curve has a gap at the cell that is no number: two dots.
    expect(cm?.querySelector('.device')?.getAttribute('d')).toMatch(/^M\S+ \S+h0M\S+ \S+h0$/);
    expect(cm?.querySelector('.simulation')?.getAttribute('d')).toMatch(/^M\S+ \S+L\S+ \S+$/);
    expect(all('.kind').map(textOf)).toEqual(['Gerät', 'Simulation']);
  });

  it('tells what to know of the file', () => {
    mountOn(page, DeviceLogWindow);
    expect(all('.remarks li').map(textOf)).toEqual([
      'Der Speicher des Geräts war voll: Spätere Zeilen fehlen.',
      'Zeile 3, Spalte cm: «nan» ist keine Zahl. Dort hat die Kurve eine Lücke (1 im Ganzen).',
    ]);
    expect(textOf(document.querySelector('.legend'))).toMatch(/MY_DATA\.HTM ?3 Zeilen ?voll/);
    expect(textOf(document.querySelector('.content'))).toContain('Die Simulation hat noch nichts aufgeschrieben.');
  });

  it('puts both on the same axes: an equal reading at an equal time is in the same place', () => {
    page.dataLog.take([logged('0.10', '12.5', '0'), logged('0.30', '11', '0')]);
    mountOn(page, DeviceLogWindow);
    const placesOf = (kind: string) =>
      all(`.charts .${kind}`)[0]
        ?.getAttribute('d')
        ?.match(/\d[\d.]* \d[\d.]*/g);
    expect(placesOf('device')).toEqual(placesOf('simulation'));
  });

  it('closes, and opens again from the data log', async () => {
    page.dataLog.isCompared.value = true;
    mountOn(page, DeviceLogWindow);
    named('Schliessen').click();
    expect(page.dataLog.isCompared.value).toBe(false);
    expect(page.dataLog.device.value).not.toBeNull();
    mountOn(page, DeviceLogRow);
    named('Mit der Simulation vergleichen: MY_DATA.HTM').click();
    await nextTick();
    expect(page.dataLog.isCompared.value).toBe(true);
  });

  it('takes the readings away by one button, here and in the data log', async () => {
    page.dataLog.isCompared.value = true;
    mountOn(page, DeviceLogWindow);
    named('MY_DATA.HTM entfernen').click();
    expect([page.dataLog.device.value, page.dataLog.isCompared.value]).toEqual([null, false]);
    page.dataLog.device.value = { file: 'walk.csv', log: logOf(microbitPage({ csv })) };
    mountOn(page, DeviceLogRow);
    named('walk.csv entfernen').click();
    await nextTick();
    expect(page.dataLog.device.value).toBeNull();
    expect(textOf(document.querySelector('[data-testid=open-device-log]'))).toBe('Vom Gerät öffnen');
  });
});
