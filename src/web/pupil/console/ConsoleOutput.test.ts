// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import ConsoleOutput from './ConsoleOutput.vue';

const TRACEBACK = `Traceback (most recent call last):
  File "main.py", line 2, in <module>
ZeroDivisionError: division by zero
`;

/** The console's output; `print` is what a program does, seen once the console has gathered it. */
function output() {
  const page = createPage();
  page.work.openProject(
    { files: [{ name: 'main.py', text: 'a = 0\n1 / a\n' }], scene: page.work.scene.value, course: null },
    null,
  );
  const log = mountOn(page, ConsoleOutput);
  const print = async (text: string) => {
    page.console.write(text);
    vi.advanceTimersByTime(50);
    await nextTick();
    await nextTick();
  };
  return { page, log, print, box: named('Ausgabe des Programms') };
}

/** Everything that the page keeps within an element: elements, texts and marks. */
const nodesIn = (node: Node): number => [...node.childNodes].reduce((sum, child) => sum + 1 + nodesIn(child), 0);

/** Gives the box sizes: happy-dom has no layout. */
function sized(box: HTMLElement, content: number, visible: number): void {
  Object.defineProperty(box, 'scrollHeight', { configurable: true, value: content });
  Object.defineProperty(box, 'clientHeight', { configurable: true, value: visible });
}

describe('the console’s output', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it('says before the first run what will stand there', () => {
    const { box } = output();
    expect(textOf(box)).toBe('Noch keine Ausgabe Was dein Programm mit print() schreibt, steht hier.');
  });

  it('shows what the program prints, spaces and line breaks as they are', async () => {
    const { print, log } = output();
    await print('a  b\n');
    await print('  c\n');
    expect(log.get('pre').element.textContent).toBe('a  b\n  c\n');
    expect(log.find('.empty').exists()).toBe(false);
  });

  it('has as many nodes on the page after 1,000 runs as after 500', async () => {
    const { page, print, box } = output();
    const nodesAfter = async (from: number, to: number): Promise<number> => {
      for (let number = from; number <= to; number += 1) {
        page.console.startRun(number);
        page.console.write('eins\n');
        page.console.addNote('console.stopped');
      }
      await print('zwei\n');
      return nodesIn(box);
    };
    const before = await nodesAfter(1, 500);
    expect(before).toBeGreaterThan(200);
    expect(await nodesAfter(501, 1000)).toBe(before);
  });

  it('puts a heading with its number over each run', async () => {
    const { page, log, print } = output();
    page.console.startRun(1);
    await print('eins\n');
    page.console.startRun(2);
    await print('zwei\n');
    expect(log.findAll('.run').map((it) => it.text())).toEqual(['Lauf 1', 'Lauf 2']);
  });

  it('shows the page’s own sentences apart from the program’s', async () => {
    const { page, log } = output();
    page.console.addNote('console.stopped');
    await nextTick();
    expect(log.get('.note').text()).toBe('Gestoppt.');
  });

  it('does not read every line aloud: a screen reader is told the important things elsewhere', () => {
    const { box } = output();
    expect(box.getAttribute('role')).toBe('log');
    expect(box.getAttribute('aria-live')).toBe('off');
    expect(box.tabIndex).toBe(0);
  });

  it('says that older output is left out once there is too much of it', async () => {
    const { print, log } = output();
    await print('x\n'.repeat(4000));
    expect(log.find('.dropped').exists()).toBe(false);
    await print('y\n'.repeat(4000));
    expect(log.get('.dropped').text()).toBe('Ältere Ausgabe ist weggelassen.');
    expect(log.text().endsWith('y')).toBe(true);
  });

  it('a click on a line of the traceback leads to the line of the program', async () => {
    const { page, print } = output();
    page.layout.tab.value = 'console';
    await print(TRACEBACK);
    named('File "main.py", line 2').click();
    expect(page.jump.target.value).toEqual({ file: 'main.py', line: 2 });
    expect(page.layout.tab.value).toBe('code');
  });

  it('does not offer lines of files that the project does not have', async () => {
    const { print, log } = output();
    await print(TRACEBACK.replace('main.py', 'other.py'));
    expect(log.findAll('button.place')).toHaveLength(0);
    expect(log.text()).toContain('File "other.py", line 2');
  });

  it('does not offer a place that the program only prints', async () => {
    const { print, log } = output();
    await print('File "main.py", line 2\n');
    expect(log.findAll('button.place')).toHaveLength(0);
  });

  it('folds the device’s own words into the card that explains them', async () => {
    const { page, print, log } = output();
    await print(TRACEBACK);
    expect(log.get('.log > pre').classes()).toContain('text--error');
    const failure = { type: 'ZeroDivisionError', message: 'division by zero', traceback: TRACEBACK };
    page.console.addError({ file: 'main.py', line: 2 }, { failure, source: null, table: null });
    await nextTick();
    expect(log.find('.log > pre').exists()).toBe(false);
    expect(log.findAll('[data-entry]')).toHaveLength(1);
  });

  it('the traceback of a program that was stopped is no alarm', async () => {
    const { page, print, log } = output();
    await print(TRACEBACK);
    page.console.quieten();
    await nextTick();
    expect(log.get('pre').classes()).toContain('text--quiet');
  });
});

describe('the end of the console’s output', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it('is followed while new output comes', async () => {
    const { print, box, log } = output();
    sized(box, 900, 200);
    await print('x\n');
    expect(box.scrollTop).toBe(900);
    expect(log.find('.to-end').exists()).toBe(false);
  });

  it('is not followed once the pupil has scrolled back; a button leads there again', async () => {
    const { print, box, log } = output();
    sized(box, 900, 200);
    await print('x\n');
    box.scrollTop = 100;
    await log.get('[role="log"]').trigger('scroll');
    await print('y\n');
    expect(box.scrollTop).toBe(100);
    named('Zum Ende').click();
    await nextTick();
    await nextTick();
    expect(box.scrollTop).toBe(900);
    expect(log.find('.to-end').exists()).toBe(false);
  });

  it('counts as reached a line above it: 23 px are no scrolling back, 24 are', async () => {
    const { print, box, log } = output();
    sized(box, 900, 200);
    await print('x\n');
    box.scrollTop = 700 - 23;
    await log.get('[role="log"]').trigger('scroll');
    expect(log.find('.to-end').exists()).toBe(false);
    box.scrollTop = 700 - 24;
    await log.get('[role="log"]').trigger('scroll');
    expect(log.find('.to-end').exists()).toBe(true);
  });

  it('comes into sight when the pupil sends something', async () => {
    const { page, print, box, log } = output();
    sized(box, 900, 200);
    await print('x\n');
    box.scrollTop = 0;
    await log.get('[role="log"]').trigger('scroll');
    page.console.sent.value += 1;
    await nextTick();
    await nextTick();
    expect(box.scrollTop).toBe(900);
  });
});
