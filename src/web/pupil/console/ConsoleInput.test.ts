// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import type { Ended } from '#simulation/simulation';

import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { inputsOf, show, startRun } from '../../app/testing/run';
import ConsoleInput from './ConsoleInput.vue';

const finished: Ended = { kind: 'finished', exception: null, timeUs: 1000 };

/** The line under a program that runs, with its field and what was typed into the program so far. */
async function running() {
  const page = createPage();
  const line = mountOn(page, ConsoleInput);
  await startRun(page);
  const field = line.get<HTMLInputElement>('input');
  const typed = (): string[] => inputsOf(page).flatMap((input) => (input.type === 'serial' ? [input.text] : []));
  const press = (key: string, more = {}) => field.trigger('keydown', { key, ...more });
  const enter = async (text: string) => {
    await field.setValue(text);
    await line.get('form').trigger('submit');
  };
  return { page, line, field, typed, press, enter };
}

/** Likewise once the program is over and the REPL waits. */
async function atRepl() {
  const all = await running();
  all.page.say({ type: 'program-ended', ended: finished, device: 0 });
  await show(all.page, { repl: true, running: 'world' });
  return all;
}

describe('the console’s line while the program runs', () => {
  it('sends what was typed with a carriage return and becomes empty', async () => {
    const { typed, field, enter } = await running();
    await enter('12 Äpfel');
    expect(typed()).toEqual(['12 Äpfel\r']);
    expect(field.element.value).toBe('');
  });

  it('sends with its button, too', async () => {
    const { typed, field } = await running();
    await field.setValue('ja');
    named('Senden').click();
    expect(typed()).toEqual(['ja\r']);
  });

  it('sends an empty line: input() takes Enter alone', async () => {
    const { typed, line } = await running();
    await line.get('form').trigger('submit');
    expect(typed()).toEqual(['\r']);
  });

  it('says what it is for: text for input() where the program reads any', async () => {
    const { page, field } = await running();
    page.work.setText('main.py', 'print(1)');
    await nextTick();
    expect(field.attributes('aria-label')).toBe('An das Programm senden');
    page.work.setText('main.py', 'name = input ("Name? ")');
    await nextTick();
    expect(field.attributes('aria-label')).toBe('Eingabe für input()');
    expect(field.attributes('placeholder')).toBe('Eingabe für input()');
  });

  it('takes nothing while somebody looks back, and says why: the device would not answer', async () => {
    const { page, field, line } = await running();
    await show(page, { timeUs: 2_000_000 });
    page.run.look.back();
    await nextTick();
    expect(field.element.disabled).toBe(true);
    expect(field.attributes('placeholder')).toBe('Im Rückblick hört das Gerät nicht zu.');
    expect(line.find('[data-testid="interrupt"]').exists()).toBe(false);
  });

  it('interrupts with its button and with Ctrl-C, and takes the focus', async () => {
    const { typed, press, field } = await running();
    named('Unterbrechen').click();
    expect(document.activeElement).toBe(field.element);
    await press('c', { ctrlKey: true });
    expect(typed()).toEqual(['\x03', '\x03']);
  });

  it('copies with Ctrl-C when some of its text is chosen', async () => {
    const { typed, press, field } = await running();
    await field.setValue('kopiere mich');
    field.element.setSelectionRange(0, 6);
    await press('c', { ctrlKey: true });
    expect(typed()).toEqual([]);
  });

  it('leaves Ctrl-Shift-C and a plain c to the browser', async () => {
    const { typed, press } = await running();
    await press('C', { ctrlKey: true, shiftKey: true });
    await press('c');
    await press('d', { ctrlKey: true, altKey: true });
    expect(typed()).toEqual([]);
  });

  it('restarts by interrupting first: only the REPL takes Ctrl-D', async () => {
    const { typed, press } = await running();
    named('Neustart').click();
    await press('d', { ctrlKey: true });
    expect(typed()).toEqual(['\x03\x04', '\x03\x04']);
  });

  it('brings back earlier lines with the arrow keys, and what was being typed', async () => {
    const { press, field, enter } = await running();
    await enter('eins');
    await enter('zwei');
    await field.setValue('dr');
    await press('ArrowUp');
    expect(field.element.value).toBe('zwei');
    await press('ArrowUp');
    expect(field.element.value).toBe('eins');
    await press('ArrowDown');
    await press('ArrowDown');
    expect(field.element.value).toBe('dr');
  });

  it('sends several pasted lines as one piece, with what stood there before', async () => {
    const { typed, field } = await running();
    await field.setValue('a = ');
    await field.trigger('paste', { clipboardData: { getData: () => '1\r\n2\r\n' } });
    expect(typed()).toEqual(['a = 1\r2\r']);
    expect(field.element.value).toBe('');
  });

  it('leaves one pasted line to the browser', async () => {
    const { typed, field } = await running();
    const event = Object.assign(new Event('paste', { cancelable: true }), {
      clipboardData: { getData: () => 'x = 1' },
    });
    field.element.dispatchEvent(event);
    expect(event.defaultPrevented).toBe(false);
    expect(typed()).toEqual([]);
  });

  it('tells the console that something was sent: it shows its end from then on', async () => {
    const { page, enter } = await running();
    const before = page.console.sent.value;
    await enter('x');
    expect(page.console.sent.value).toBe(before + 1);
  });
});

describe('the console’s line while the program waits in input()', () => {
  afterEach(() => void vi.unstubAllGlobals());

  const waits = async (before: (page: Awaited<ReturnType<typeof running>>['page']) => void = () => undefined) => {
    const all = await running();
    before(all.page);
    await show(all.page, { awaitsInput: true });
    await nextTick();
    return all;
  };
  const beside = (html: string): HTMLElement => {
    document.body.insertAdjacentHTML('beforeend', html);
    const element = document.body.lastElementChild?.querySelector<HTMLElement>('[tabindex]');
    element?.focus();
    return element ?? document.body;
  };

  it('is marked and has the keyboard', async () => {
    const { field, line } = await waits();
    expect(document.activeElement).toBe(field.element);
    expect(line.classes()).toContain('line--waiting');
    expect(field.attributes('placeholder')).toBe('Eingabe für input()');
  });

  it('is an ordinary field again when the program goes on', async () => {
    const { page, line } = await waits();
    await show(page, { awaitsInput: false });
    expect(line.classes()).not.toContain('line--waiting');
  });

  it('takes the keyboard from the editor, where Ctrl+Enter was pressed', async () => {
    const { field } = await waits(() => beside('<div class="cm-editor"><i tabindex="0"></i></div>'));
    expect(document.activeElement).toBe(field.element);
  });

  it('leaves it to whoever has gone on writing the program, but is marked', async () => {
    let editor: HTMLElement | null = null;
    const { line } = await waits((page) => {
      editor = beside('<div class="cm-editor"><i tabindex="0"></i></div>');
      page.work.setText('main.py', 'name = input()');
    });
    expect(document.activeElement).toBe(editor);
    expect(line.classes()).toContain('line--waiting');
  });

  it.each(['<p role="dialog"><i tabindex="0"></i></p>', '<p role="menu"><i tabindex="0"></i></p>'])(
    'leaves it to %s',
    async (html) => {
      let other: HTMLElement | null = null;
      await waits(() => (other = beside(html)));
      expect(document.activeElement).toBe(other);
    },
  );

  it('does not bring up the keyboard of a touch screen', async () => {
    const isCoarse = (query: string) => Object.assign(new EventTarget(), { matches: query === '(pointer: coarse)' });
    vi.stubGlobal('matchMedia', isCoarse);
    const { field, line } = await waits();
    expect(document.activeElement).not.toBe(field.element);
    expect(line.classes()).toContain('line--waiting');
  });
});

describe('the console’s line at the REPL', () => {
  it('asks for a Python line behind the prompt', async () => {
    const { page, line, field } = await atRepl();
    page.say({ type: 'console', output: [{ device: 0, text: '>>> ', timeUs: 0 }] });
    page.console.toText(); // shows what waits
    await nextTick();
    expect(field.attributes('placeholder')).toBe('Python-Zeile ausprobieren');
    expect(textOf(line.get('.mark').element)).toBe('>>>');
  });

  it('is not gone to by answering input(), but by a click, a key or an interrupt', async () => {
    const { page, field, press } = await running();
    await field.trigger('focus');
    await press('5');
    page.say({ type: 'program-ended', ended: finished, device: 0 });
    await show(page, { repl: true, running: 'world' });
    expect(page.console.isReplVisited.value).toBe(false);
    await press('p');
    expect(page.console.isReplVisited.value).toBe(true);
    await page.run.start();
    expect(page.console.isReplVisited.value).toBe(false);
    await field.trigger('pointerdown'); // its program is still starting
    expect(page.console.isReplVisited.value).toBe(false);
    named('Unterbrechen').click();
    expect(page.console.isReplVisited.value).toBe(true);
  });

  it('keeps the indentation of a block for its next line', async () => {
    const { field, enter } = await atRepl();
    await enter('for i in range(3):');
    expect(field.element.value).toMatch(/^ +$/);
  });

  it('restarts with Ctrl-D alone', async () => {
    const { typed } = await atRepl();
    named('Neustart').click();
    expect(typed()).toEqual(['\x04']);
  });

  it('takes several pasted lines in paste mode, between Ctrl-E and Ctrl-D', async () => {
    const { typed, field } = await atRepl();
    await field.trigger('paste', { clipboardData: { getData: () => 'if True:\n  print(1)\n' } });
    expect(typed()).toEqual(['\x05if True:\r  print(1)\x04']);
  });
});
