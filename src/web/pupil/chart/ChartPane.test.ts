// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { flushPromises } from '@vue/test-utils';
import { nextTick, shallowRef } from 'vue';

import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { startRun, show } from '../../app/testing/run';
import { realBoard, type BoardText } from '../../session/run/board/real-board';
import ChartPane from './ChartPane.vue';

let page: TestPage;
let head: HTMLElement;
beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  page = createPage();
  head = document.createElement('div');
  document.body.append(head);
  return () => vi.useRealTimers();
});
async function pass(): Promise<void> {
  await flushPromises();
  vi.advanceTimersByTime(1000);
  await nextTick();
  await nextTick();
}
const values = (): readonly string[] =>
  [...head.querySelectorAll('.values li')].map(
    (it) => `${textOf(it.querySelector('.name'))} ${textOf(it.querySelector('b'))}`,
  );

describe('the chart', () => {
  it('says so while there is nothing to draw', () => {
    const pane = mountOn(page, ChartPane, { head });
    expect(pane.text()).toContain('Noch nichts zu zeichnen');
    expect((named('Verlauf speichern') as HTMLButtonElement).disabled).toBe(true);
  });

  it('draws the numbers that the program prints, each with its name, before anybody has chosen', async () => {
    await startRun(page);
    await show(page, { timeUs: 100_000 });
    page.run.recording.value.addOutput({ device: 0, text: 'Abstand: 23\nlinks: 1\n', timeUs: 20_000 });
    page.run.recording.value.addOutput({ device: 0, text: 'Abstand: 21\n', timeUs: 60_000 });
    mountOn(page, ChartPane, { head });
    await pass();
    expect(values()).toEqual(['Abstand 21', 'links 1']);
    expect(document.querySelector('[data-testid=chart-plot]')?.getAttribute('aria-valuetext')).toBe(
      '00:00.10, Abstand 21, links 1',
    );
    expect(textOf(document.querySelector('#chart-about'))).toContain('Abstand: von 21 bis 23');
  });

  it('draws what the same program prints on a real board beside it, from its own start on', async () => {
    const count = shallowRef(0);
    const output: BoardText[] = [];
    realBoard(page).value = {
      ...{ name: shallowRef('micro:bit V2'), state: shallowRef('connected'), start: shallowRef(1), count, output },
      ...{ outputGone: 0, send: () => undefined, disconnect: () => Promise.resolve() },
    };
    await startRun(page);
    await show(page, { timeUs: 100_000 });
    page.run.recording.value.addOutput({ device: 0, text: 'Abstand: 23\n', timeUs: 20_000 });
    mountOn(page, ChartPane, { head });
    await pass();
    output.push({ device: 0, text: 'Abstand: 25\r\n', timeUs: 30_000 });
    count.value += 1;
    await pass();
    expect(values()).toEqual(['Abstand 23', 'Abstand · micro:bit V2 25']);
    realBoard(page).value = null;
    await pass();
    expect(values()).toEqual(['Abstand 23']);
  });

  it('leads to the moment that a key of the time line leads to', async () => {
    await startRun(page);
    await show(page, { timeUs: 100_000 });
    page.run.recording.value.addOutput({ device: 0, text: '1\n', timeUs: 20_000 });
    const pane = mountOn(page, ChartPane, { head });
    await pass();
    await pane.get('[data-testid=chart-plot]').trigger('keydown', { key: 'ArrowLeft' });
    expect(page.run.past.value).not.toBeNull();
    expect(page.run.recording.value.asked.value).toEqual({ timeUs: 80_000 });
  });
});
