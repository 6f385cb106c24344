// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, setWindow } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { show, startRun } from '../../app/testing/run';
import { realBoard, type RealBoard } from '../../session/run/board/real-board';
import ConsolePane from './ConsolePane.vue';

/** A console in a window of this size. */
async function consoleIn(width: number, height: number) {
  setWindow(width, height);
  const page = createPage();
  const pane = mountOn(page, ConsolePane);
  const print = async (text: string): Promise<void> => {
    page.console.write(text);
    page.console.toText();
    await vi.dynamicImportSettled();
    await nextTick();
  };
  const fold = async (): Promise<void> => {
    pane.get<HTMLElement>('[data-testid="console-fold"]').element.click();
    await nextTick();
  };
  await vi.dynamicImportSettled();
  await nextTick();
  return { page, pane, print, fold, isFolded: () => page.layout.isConsoleFolded.value };
}

describe('the console beside the arena', () => {
  afterEach(() => setWindow(1024, 768));

  it('shows its head alone while it is empty', async () => {
    const { page, pane, isFolded } = await consoleIn(1366, 625);
    expect(isFolded()).toBe(true);
    expect(pane.find('.frame').exists()).toBe(false);
    await startRun(page);
    expect(isFolded()).toBe(true);
  });

  it('stays folded for what the program prints, and shows its latest line in the head', async () => {
    const { page, pane, print, isFolded } = await consoleIn(1366, 625);
    await startRun(page);
    await print('Abstand 12\nAbstand 11\n');
    expect([isFolded(), pane.get('.latest').text()]).toEqual([true, 'Abstand 11']);
    page.console.clear();
    await nextTick();
    expect(pane.find('.latest').exists()).toBe(false);
  });

  it('opens for what the program prints where no arena is in sight, and closes when it is cleared', async () => {
    const { page, pane, print, isFolded } = await consoleIn(1366, 625);
    page.settings.change({ showArena: false });
    await startRun(page);
    await print('Hallo\n');
    expect([isFolded(), pane.get('.frame').isVisible()]).toEqual([false, true]);
    page.console.clear();
    await nextTick();
    expect(isFolded()).toBe(true);
  });

  it('opens for a question of the program', async () => {
    const { page, isFolded } = await consoleIn(1366, 625);
    await startRun(page);
    await show(page, { awaitsInput: true });
    expect(isFolded()).toBe(false);
  });

  it('opens for a real board, whose output stands beside it', async () => {
    const { page, pane, isFolded } = await consoleIn(1366, 625);
    expect(pane.find('.sides').exists()).toBe(false);
    realBoard(page).value = {} as RealBoard;
    await nextTick();
    expect([isFolded(), pane.find('.sides').exists()]).toEqual([false, true]);
  });

  it('stays closed for the greeting of the REPL', async () => {
    const { page, print, isFolded } = await consoleIn(1366, 625);
    await startRun(page);
    page.console.addNote('console.finished');
    await print('MicroPython v1.18 on 2023-10-30; micro:bit v2.1.2\r\nType "help()" for more information.\r\n>>> ');
    expect(isFolded()).toBe(true);
  });

  it('stays closed at a stop, whatever the device says to it', async () => {
    const { page, print, isFolded } = await consoleIn(1366, 625);
    await startRun(page);
    await print('Traceback (most recent call last):\n  File "main.py", line 1, in <module>\nKeyboardInterrupt:\n');
    expect(isFolded()).toBe(true);
    page.console.quieten();
    await print('MicroPython v1.18 on 2023-10-30; micro:bit v2.1.2\r\nType "help()" for more information.\r\n>>> ');
    page.console.addNote('console.interrupted');
    await nextTick();
    expect(isFolded()).toBe(true);
  });

  it('opens and closes by hand, until the next run', async () => {
    const { page, print, fold, isFolded } = await consoleIn(1366, 625);
    await fold();
    expect(isFolded()).toBe(false);
    await startRun(page);
    expect(isFolded()).toBe(true);
    await fold();
    await print('1\n');
    expect(isFolded()).toBe(false);
    void page.run.stop();
    await startRun(page);
    expect(isFolded()).toBe(true);
  });

  it('opens for an error, also when it was closed by hand', async () => {
    const { page, fold, isFolded } = await consoleIn(1366, 625);
    await fold();
    await fold();
    page.console.addError(null, {
      failure: { type: 'ValueError', message: 'x', typed: false },
      source: '',
      table: null,
    } as never);
    await nextTick();
    expect(isFolded()).toBe(false);
    page.console.startRun(2);
    await nextTick();
    expect(isFolded()).toBe(true); // the next run has no error yet
  });

  it('does not fold behind the tab of a phone', async () => {
    const { pane } = await consoleIn(390, 844);
    expect(pane.find('[data-testid="console-fold"]').exists()).toBe(false);
    expect(pane.get('.frame').isVisible()).toBe(true);
  });
});
