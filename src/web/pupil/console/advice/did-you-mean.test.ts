import { describe, expect, it } from 'vitest';

import { play } from '#vm/library/testing/play';
import { lastPlace } from '../log/console-log';
import { robotReferences } from '#robots/references';
import { otherNames } from '#advice/other-names';
import { meantName } from './did-you-mean';

/** On the usual board, with nothing beside the program. */
const alone = { hardware: null, files: [], file: 'main.py' } as const;

/** Runs a program with a mistake on our VM and gives the name that the page asks about. */
function meantIn(program: string): string | null {
  const exception = play(program).until(30_000).ended()?.exception;
  if (exception === null || exception === undefined) throw new Error(`No error in: ${program}`);
  const line = lastPlace(exception.traceback, ['main.py'])?.line ?? 1;
  return meantName(exception, { text: program, line }, alone);
}

/** An error as the device writes it, where the program needs more than a bare board. */
const meantOnRobot = (name: string, call: string): string | null =>
  meantName(
    { type: 'NameError', message: `name '${name}' isn't defined` },
    { text: `from mbrobot import *\nsetSpeed(40)\n${call}\n`, line: 3 },
    alone,
  );

describe('the question what was meant', () => {
  it('names a command of the robot', () => {
    expect(meantOnRobot('forwart', 'forwart()')).toBe('forward');
    expect(meantOnRobot('getdistance', 'print(getdistance())')).toBe('getDistance');
  });

  it('names a command by its word in German, French, Italian and English, and by a short form', () => {
    for (const word of ['vorwärts', 'vorwaerts', 'Vorwaerts_fahren', 'avancer', 'avanti', 'go_forward', 'fwd'])
      expect([word, meantOnRobot(word, `${word}()`)]).toEqual([word, 'forward']);
    for (const word of ['back', 'zurück', 'rueckwaerts', 'reculer', 'arrière', 'indietro'])
      expect([word, meantOnRobot(word, `${word}()`)]).toEqual([word, 'backward']);
    expect(meantOnRobot('warte', 'warte(500)')).toBe('delay');
    expect(meantOnRobot('irLinks', 'print(irLinks.read_digital())')).toBe('irLeft');
  });

  it('names no command for a word that is used otherwise', () => {
    expect(meantOnRobot('links', 'x = links + 1')).toBeNull();
    expect(meantOnRobot('led', 'led.on()')).toBeNull();
  });

  const modules = robotReferences.flatMap((it) => it.modules);
  it.each(modules.map(({ name, names }) => [name, names] as const))(
    'knows every word for the commands of %s',
    (module, names) => {
      for (const { commands, words } of otherNames) {
        const command = commands.find((it) => names[it]?.kind === 'function' || names[it]?.kind === 'value');
        if (command === undefined) continue;
        for (const word of [words[0]!, words.at(-1)!]) {
          const call = names[command]?.kind === 'function' ? `${word}()` : `${word}.x`;
          const failure = { type: 'NameError', message: `name '${word}' isn't defined` };
          const source = { text: `from ${module} import *\n${call}`, line: 2 };
          expect([word, meantName(failure, source, alone)]).toEqual([word, command]);
        }
      }
    },
  );

  it('knows no word for a command that no robot and no board has', () => {
    const all = new Set(
      modules.flatMap(({ names }) => [
        ...Object.keys(names),
        ...Object.values(names).flatMap((it) => Object.keys(it.members)),
      ]),
    );
    expect(otherNames.flatMap(({ commands }) => commands).filter((it) => !all.has(it))).toEqual(['sleep']);
  });

  it('names a variable, a function and a word of Python', () => {
    expect(meantIn('anzahl = 3\nprint(anzhal)')).toBe('anzahl');
    expect(meantIn('def kreis():\n    pass\nkries()')).toBe('kreis');
    expect(meantIn('pritn("a")')).toBe('print');
  });

  it('names what stands behind a dot', () => {
    expect(meantIn('from microbit import *\ndisplay.sow("a")')).toBe('show');
    expect(meantIn('from microbit import *\ndisplay.show(Image.HAERT)')).toBe('HEART');
  });

  it('names a function of another file', () => {
    const files = [{ name: 'fahren.py', text: 'def kurve():\n    pass\n' }];
    const failure = { type: 'NameError', message: "name 'kruve' isn't defined" };
    const source = { text: 'from fahren import *\nkruve()', line: 2 };
    expect(meantName(failure, source, { ...alone, files })).toBe('kurve');
  });

  it('names a module and a name out of it', () => {
    expect(meantIn('import musik')).toBe('music');
    expect(meantIn('from microbit import buton_a')).toBe('button_a');
  });

  it('stays away where nothing is near, and where the error is about something else', () => {
    expect(meantIn('print(irLinks)')).toBeNull();
    expect(meantIn('print(1 / 0)')).toBeNull();
  });
});
