// @vitest-environment happy-dom
import { beforeAll, describe, expect, it } from 'vitest';

import { createPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import { fetchAdvice } from './advice/explain';
import { errorSentence, placeIn, sourceAt } from './error-text';

const files = [
  { name: 'main.py', text: 'import helfer\nhelfer.teile(0)\n' },
  { name: 'helfer.py', text: 'def teile(x):\n    return 1 / x\n' },
];
const traceback = `Traceback (most recent call last):
  File "main.py", line 2, in <module>
  File "helfer.py", line 2, in teile
ZeroDivisionError: divide by zero
`;
const exception = { type: 'ZeroDivisionError', message: 'divide by zero', line: 2, traceback };

/** A page with these files. */
function page() {
  const parts = createPage();
  parts.work.openProject({ files, scene: parts.work.scene.value, course: null }, null);
  return parts;
}

describe('what a screen reader hears of an error', () => {
  beforeAll(async () => {
    await loadTexts('de');
    await fetchAdvice();
  });

  it('is the file and the line that it happened in, then what it means', () => {
    const sentence = errorSentence({ kind: 'exception', exception, timeUs: 5 }, page());
    expect(sentence).toBe('Fehler in helfer.py, Zeile 2: Durch null lässt sich nicht teilen.');
  });

  it('has no line where the error is in none of the pupil’s files', () => {
    const elsewhere = { ...exception, traceback: traceback.replaceAll(/(main|helfer)\.py/g, 'x.py') };
    const sentence = errorSentence({ kind: 'exception', exception: elsewhere, timeUs: 5 }, page());
    expect(sentence).toMatch(/^Fehler im Programm: ./);
  });

  it('has the name that was meant, which comes a moment later', () => {
    const late = {
      advice: { key: 'error.unknownName' as const, values: { name: 'vor' } },
      meant: 'forward',
      mend: undefined,
    };
    expect(errorSentence({ kind: 'exception', exception, timeUs: 5 }, page(), late)).toBe(
      'Fehler in helfer.py, Zeile 2: Den Namen vor kennt das Programm nicht. Meinst du forward?',
    );
  });

  it('names the line in which a bracket opens, wherever the device has noticed it', () => {
    const parts = page();
    parts.work.setText('main.py', 'print(1\n\nx = 3');
    const failure = {
      type: 'SyntaxError',
      message: 'invalid syntax',
      line: 3,
      traceback: '  File "main.py", line 3\n',
    };
    expect(errorSentence({ kind: 'exception', exception: failure, timeUs: 5 }, parts)).toBe(
      'Fehler in main.py, Zeile 1: Die Klammer ( in Zeile 1 ist nicht geschlossen.',
    );
  });

  it('is nothing for a program that ended without one', () => {
    expect(errorSentence({ kind: 'finished', exception: null, timeUs: 5 }, page())).toBe('');
  });
});

describe('the place of an error', () => {
  it('is the innermost line in a file of the pupil', () => {
    expect(placeIn(traceback, files)).toEqual({ file: 'helfer.py', line: 2 });
    expect(placeIn(traceback, files.slice(0, 1))).toEqual({ file: 'main.py', line: 2 });
    expect(placeIn(traceback, [])).toBeNull();
  });

  it('brings the text of its file along, for errors that are explained by what is written there', () => {
    expect(sourceAt({ file: 'helfer.py', line: 2 }, files)).toEqual({ text: files[1]!.text, line: 2 });
    expect(sourceAt({ file: 'weg.py', line: 2 }, files)).toBeNull();
    expect(sourceAt(null, files)).toBeNull();
  });
});
