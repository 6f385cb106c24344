// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, describe, expect, it } from 'vitest';

import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { inputsOf, startRun } from '../../app/testing/run';
import { fetchAdvice } from './advice/explain';
import type { ErrorReport } from './advice/error-advice';
import ErrorCard from './ErrorCard.vue';

const text = 'def gruss():\n    pint("Hallo")\n\ngruss()\n';
const nameError: ErrorReport = {
  failure: { type: 'NameError', message: "name 'pint' isn't defined", traceback: 'Traceback' },
  source: { text, line: 2 },
  table: null,
};

/** A page with this program in these files. */
function pageWith(...files: readonly string[]) {
  const page = createPage();
  page.work.openProject(
    { files: files.map((name) => ({ name, text })), scene: page.work.scene.value, course: null },
    null,
  );
  return page;
}

describe('the card of an error', () => {
  beforeAll(() => fetchAdvice());

  it('names the line, what is wrong in the pupil’s language, and the device’s own words', () => {
    const card = mountOn(pageWith('main.py'), ErrorCard, { place: { file: 'main.py', line: 2 }, report: nameError });
    expect(textOf(card.get('p').element)).toMatch(/^Zeile 2: .*pint/);
    expect(card.get('code').text()).toContain('NameError');
    expect(card.get('code').text()).toContain("name 'pint' isn't defined");
  });

  it('has the device’s own words, with the lines that they name, on a tap', async () => {
    const page = pageWith('main.py');
    const traceback = [
      { id: 1, kind: 'text', tone: 'error', lines: 2, text: 'Traceback\n  File "main.py", line 4\n' },
    ] as const;
    const props = { place: { file: 'main.py', line: 2 }, report: nameError, traceback };
    const card = mountOn(page, ErrorCard, props);
    const words = card.get('.device').element as HTMLElement;
    expect(words.style.display).toBe('none');
    await card.get('[data-testid="error-raw"]').trigger('click');
    expect(words.style.display).toBe('');
    named('File "main.py", line 4').click();
    expect(page.jump.target.value).toEqual({ file: 'main.py', line: 4 });
  });

  it('leads to the line', () => {
    const page = pageWith('main.py');
    page.layout.tab.value = 'console';
    mountOn(page, ErrorCard, { place: { file: 'main.py', line: 2 }, report: nameError });
    named('Zur Zeile 2').click();
    expect(page.jump.target.value).toEqual({ file: 'main.py', line: 2 });
    expect(page.layout.tab.value).toBe('code');
  });

  it('names the file where it is not main.py, and opens it', () => {
    const page = pageWith('main.py', 'helfer.py');
    const card = mountOn(page, ErrorCard, { place: { file: 'helfer.py', line: 2 }, report: nameError });
    expect(textOf(card.get('p').element)).toMatch(/^helfer\.py, Zeile 2:/);
    named('Zur Zeile 2').click();
    expect(page.work.work.value.open).toBe('helfer.py');
  });

  it('asks nothing where no name is like it', async () => {
    const report = { ...nameError, failure: { ...nameError.failure, message: "name 'qqxzzw' isn't defined" } };
    const card = mountOn(pageWith('main.py'), ErrorCard, { place: { file: 'main.py', line: 2 }, report });
    await import('./advice/did-you-mean');
    await flushPromises();
    expect(card.findAll('p b')).toHaveLength(1);
  });

  it('has no place to lead to for a line typed at the REPL', () => {
    const report = { ...nameError, source: null };
    const card = mountOn(pageWith('main.py'), ErrorCard, { place: null, report });
    expect(card.findAll('button').map((it) => it.text())).toEqual(['Was das Gerät sagt']);
    expect(textOf(card.get('p').element)).not.toContain('Zeile');
  });

  it('says at least that an unknown exception ended the program', () => {
    const report = { ...nameError, failure: { type: 'MeinFehler', message: 'oh', traceback: '' }, source: null };
    const card = mountOn(pageWith('main.py'), ErrorCard, { place: null, report });
    expect(textOf(card.get('p').element)).toContain('Fehler');
    expect(card.get('code').text()).toBe('MeinFehler: oh');
  });

  it('offers to write a loop of TigerJython anew, once', async () => {
    const page = pageWith('main.py');
    const before = 'repeat 4:\n    print(1)';
    page.work.setText('main.py', before);
    const failure = { type: 'SyntaxError', message: 'invalid syntax', traceback: '' };
    const report = { failure, source: { text: before, line: 1 }, table: null };
    const card = mountOn(page, ErrorCard, { place: { file: 'main.py', line: 1 }, report });
    named('Ändern in for i in range(4):').click();
    const after = 'for i in range(4):\n    print(1)';
    expect(page.jump.mending.value).toEqual({ file: 'main.py', before, after });
    page.work.setText('main.py', after);
    await flushPromises();
    expect(card.find('.mend').exists()).toBe(false);
  });

  it('leads to the variables of then, but not where the program could not be read: no line of it has run', async () => {
    const page = pageWith('main.py');
    await startRun(page);
    for (const [type, leads] of [
      ['ValueError', true],
      ['SyntaxError', false],
    ] as const) {
      // prettier-ignore
      const failure = { type, message: 'x', traceback: '', line: 1 };
      page.say({ type: 'program-ended', device: 0, ended: { kind: 'exception', exception: failure, timeUs: 1000 } });
      const report = { failure: page.run.ended.value!.exception!, source: { text: 'x', line: 1 }, table: null };
      const card = mountOn(page, ErrorCard, { place: { file: 'main.py', line: 1 }, report });
      expect(card.find('[data-testid="error-look"]').exists(), type).toBe(leads);
    }
  });

  it('leads to lines of Python where the device’s words stand, and ends for it what the display shows', async () => {
    const page = pageWith('main.py');
    await startRun(page);
    const failure = { ...nameError.failure, traceback: '', line: 2 };
    page.say({ type: 'program-ended', device: 0, ended: { kind: 'exception', exception: failure, timeUs: 1000 } }); // prettier-ignore
    const card = mountOn(page, ErrorCard, { place: { file: 'main.py', line: 2 }, report: { ...nameError, failure } });
    await card.get('.device [data-testid="error-repl"]').trigger('click');
    expect(page.console.isReplVisited.value).toBe(true);
    expect(inputsOf(page)).toEqual([{ type: 'serial', text: '\x03' }]);
    expect(card.find('[data-testid="error-repl"]').exists()).toBe(false);
  });

  it('names and leads to the line in which a bracket opens', () => {
    const page = pageWith('main.py');
    const failure = { type: 'SyntaxError', message: 'invalid syntax', traceback: '' };
    const report = { failure, source: { text: 'print(1\n\nx = 3', line: 3 }, table: null };
    const card = mountOn(page, ErrorCard, { place: { file: 'main.py', line: 3 }, report });
    expect(textOf(card.get('p').element)).toBe('Die Klammer ( in Zeile 1 ist nicht geschlossen.');
    named('Zur Zeile 1').click();
    expect(page.jump.target.value).toEqual({ file: 'main.py', line: 1 });
  });
});
