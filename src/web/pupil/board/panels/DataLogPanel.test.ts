// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { downloads } from '../../../app/testing/downloads';
import { mountOn, named, textOf } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import DataLogPanel from './DataLogPanel.vue';

const row = (...values: readonly string[]) => ({ type: 'row' as const, headings: ['t', 'cm'], values, timeUs: 0 });

/** The panel of the data log; `take` is what the program logs, seen once the panel has followed it. */
function panel() {
  const page = createPage();
  const mounted = mountOn(page, DataLogPanel);
  const take = async (...events: Parameters<typeof page.dataLog.take>[0]) => {
    page.dataLog.take(events);
    vi.advanceTimersByTime(200);
    await nextTick();
    await nextTick();
  };
  const cells = () => mounted.findAll('tr.data').map((it) => it.findAll('td').map((cell) => cell.text()));
  return { page, mounted, take, cells };
}
const button = (name: string) => named(name, 'button') as HTMLButtonElement;

describe('the table of the data log', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it('says what will stand there, and has nothing to save or to empty', () => {
    const { mounted } = panel();
    expect(mounted.get('.tag').text()).toBe('0 Zeilen');
    expect(textOf(mounted.get('.panel-empty').element)).toBe(
      'Noch keine Daten Was dein Programm mit log.add() aufschreibt, steht hier als Tabelle.',
    );
    expect(button('Als Tabelle speichern (CSV)').disabled).toBe(true);
    expect(button('Tabelle leeren').disabled).toBe(true);
  });

  it('has a column for each name and a line for each row', async () => {
    const { mounted, take, cells } = panel();
    await take(row('0', '12.5'), row('1', '11'));
    expect(mounted.findAll('th').map((it) => it.text())).toEqual(['t', 'cm']);
    expect(mounted.findAll('th').every((it) => it.attributes('scope') === 'col')).toBe(true);
    expect(cells()).toEqual([
      ['0', '12.5'],
      ['1', '11'],
    ]);
    expect(mounted.get('.tag').text()).toBe('2 Zeilen');
  });

  it('says one row in the singular', async () => {
    const { mounted, take } = panel();
    await take(row('0', '12.5'));
    expect(mounted.get('.tag').text()).toBe('1 Zeile');
  });

  it('leaves cells empty that came before their column', async () => {
    const { take, cells } = panel();
    await take({ type: 'row', headings: ['t'], values: ['0'], timeUs: 0 }, row('1', '11'));
    expect(cells()).toEqual([
      ['0', ''],
      ['1', '11'],
    ]);
  });

  it('draws what is in sight only, and tells screen readers how many rows there are', async () => {
    const { mounted, take, cells } = panel();
    await take(...Array.from({ length: 1000 }, (_, number) => row(String(number), '0')));
    expect(cells().length).toBeLessThan(60);
    expect(mounted.get('table').attributes('aria-rowcount')).toBe('1001');
    expect(mounted.get('tr.data').attributes('aria-rowindex')).toBe(String(Number(cells()[0]![0]) + 2));
  });

  it('draws the rows that are scrolled to', async () => {
    const { mounted, take, cells } = panel();
    await take(...Array.from({ length: 1000 }, (_, number) => row(String(number), '0')));
    const box = mounted.get('[role="group"]');
    Object.defineProperty(box.element, 'clientHeight', { configurable: true, value: 280 });
    box.element.scrollTop = 28 * 500;
    await box.trigger('scroll');
    expect(cells().map(([number]) => number)).toContain('505');
    expect(cells().map(([number]) => number)).not.toContain('0');
  });

  it('says that the device’s memory is full, until the program empties it', async () => {
    const { mounted, take } = panel();
    await take(row('0', '1'), { type: 'full', timeUs: 0 });
    expect(mounted.get('.tag--warn').text()).toBe('voll');
    expect(mounted.get('.tag--warn').attributes('title')).toContain('Neue Zeilen gehen verloren.');
    await take({ type: 'clear', timeUs: 0 });
    expect(mounted.find('.tag--warn').exists()).toBe(false);
    expect(mounted.find('table').exists()).toBe(false);
  });

  it('is emptied by hand', async () => {
    const { page, take } = panel();
    await take(row('0', '1'));
    button('Tabelle leeren').click();
    expect(page.dataLog.table.value.rows).toEqual([]);
  });

  it('is saved as a file for spreadsheets with all its rows, and that is said', async () => {
    const { page, take } = panel();
    await take(row('0', 'links, rechts'), row('1', '"x"'));
    const saved = downloads();
    button('Als Tabelle speichern (CSV)').click();
    vi.restoreAllMocks();
    expect(saved.map(({ name }) => name)).toEqual(['data-log.csv']);
    expect(saved[0]?.blob.type).toContain('text/csv');
    expect(await saved[0]?.blob.text()).toMatch(/^t,cm\r?\n0,"links, rechts"\r?\n1,"""x"""\r?\n?$/);
    expect(page.notices.current.value).toMatchObject({ key: 'files.saved', values: { file: 'data-log.csv' } });
  });
});
