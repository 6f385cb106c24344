import { indentUnit } from '@codemirror/language';
import { history, undo } from '@codemirror/commands';
import { nextSnippetField } from '@codemirror/autocomplete';
import { EditorState } from '@codemirror/state';
import { describe, expect, it } from 'vitest';

import { microbitV2 } from '#board/boards/microbit-v2';
import { findRobot } from '#robots/index';
import type { Hardware } from '#simulation/hardware';
import { bringNames } from './bring-names';
import { commandNamed, type CommandId } from './commands';
import { insertion, type Drop } from './insert';

const hardware = { board: microbitV2, firmware: null, robot: findRobot('maqueen-lite') } as unknown as Hardware;
const written = { hardware, files: [], file: 'main.py' };
const ROBOT = 'from mbrobot import *\n';
const BOARD = 'from microbit import *\n';

/** A program; `|` is the cursor, `‹ ›` what is marked. */
function program(marked: string): EditorState {
  const from = marked.search(/[|‹]/);
  const to = marked.includes('›') ? marked.indexOf('›') - 1 : from;
  return EditorState.create({
    doc: marked.replace(/[|‹›]/g, ''),
    selection: { anchor: from, head: to },
    extensions: [indentUnit.of('    '), history()],
  });
}

function shown({ doc, selection: { main } }: EditorState): string {
  const text = doc.toString();
  const middle = main.empty ? '|' : `‹${text.slice(main.from, main.to)}›`;
  return text.slice(0, main.from) + middle + text.slice(main.to);
}

function put(state: EditorState, id: CommandId, drop: Drop | null = null): EditorState {
  return state.update(insertion(state, bringNames(commandNamed(id), state.doc.toString(), written), drop)).state;
}

const done = (marked: string, ...ids: readonly CommandId[]): string =>
  shown(ids.reduce((state, id) => put(state, id), program(marked)));

describe('a command of the palette', () => {
  it('gets a line of its own below the cursor, one after the other', () => {
    expect(done(`${ROBOT}sto|p()\nbeep()`, 'forward', 'stop')).toBe(`${ROBOT}stop()\nforward()\nstop()|\nbeep()`);
  });

  it('takes an empty line', () => {
    expect(done(`${ROBOT}\n|\nstop()`, 'forward')).toBe(`${ROBOT}\nforward()|\nstop()`);
    expect(done(`${ROBOT}if True:\n    stop()\n    |`, 'forward')).toBe(`${ROBOT}if True:\n    stop()\n    forward()|`);
  });

  it('stands one step further in after a colon, also in an empty line below it', () => {
    expect(done(`${ROBOT}while True:|`, 'forward')).toBe(`${ROBOT}while True:\n    forward()|`);
    expect(done(`${ROBOT}while True:  # immer|\nstop()`, 'left')).toBe(
      `${ROBOT}while True:  # immer\n    left()|\nstop()`,
    );
    expect(done(`${ROBOT}while True:\n|`, 'forward')).toBe(`${ROBOT}while True:\n    forward()|`);
  });

  it('goes into the block that was just opened', () => {
    expect(done(`${ROBOT}|`, 'forever', 'near', 'stop')).toBe(
      `${ROBOT}while True:\n    if getDistance() < 20:\n        stop()|`,
    );
  });

  it('has its first value marked, and Tab goes on to the next', () => {
    expect(done(`${ROBOT}|`, 'setSpeed')).toBe(`${ROBOT}setSpeed(‹50›)`);
    let state = put(program(`${ROBOT}|`), 'fillRGB');
    expect(shown(state)).toBe(`${ROBOT}fillRGB(‹255›, 0, 0)`);
    const dispatch = (transaction: { readonly state: EditorState }): void => void (state = transaction.state);
    nextSnippetField({ state, dispatch });
    expect(shown(state)).toBe(`${ROBOT}fillRGB(255, ‹0›, 0)`);
  });

  it('does not write over a value that is still marked', () => {
    expect(done(`${ROBOT}|`, 'setSpeed', 'forward')).toBe(`${ROBOT}setSpeed(50)\nforward()|`);
  });

  it('brings the imports along that are missing, and only those', () => {
    expect(done('|', 'forward')).toBe(`${ROBOT}forward()|`);
    expect(done(`${ROBOT}forward()|`, 'clear')).toBe(`${ROBOT}${BOARD}forward()\ndisplay.clear()|`);
    expect(done('|', 'melody')).toBe('import music\nmusic.play(music.‹ODE›)');
    expect(done(`${BOARD}|`, 'random')).toBe(`${BOARD}from random import randint\nnumber = randint(‹1›, 6)`);
    expect(done('from microbit import display\n|', 'clear')).toBe('from microbit import display\ndisplay.clear()|');
  });

  it('is called as the program has imported its module', () => {
    expect(done('import mbrobot as robot\n|', 'forward')).toBe('import mbrobot as robot\nrobot.forward()|');
    expect(done('import music as m\n|', 'melody')).toBe('import music as m\nm.play(m.‹ODE›)');
  });

  it('never comes to stand above the imports', () => {
    expect(done(`|# Ich\n${ROBOT}stop()`, 'forward')).toBe(`# Ich\n${ROBOT}forward()|\nstop()`);
    expect(done('# I|ch\nprint(1)', 'forward')).toBe(`# Ich\n${ROBOT}forward()|\nprint(1)`);
  });

  it('goes where it is dropped: above or below a line, as far in as that', () => {
    const state = program(`${ROBOT}while True:\n    left()\n    stop()|`);
    const at = state.doc.toString().indexOf('stop');
    const above = put(state, 'forward', { at, isUpper: true });
    expect(shown(above)).toBe(`${ROBOT}while True:\n    left()\n    forward()|\n    stop()`);
    const below = put(state, 'forward', { at, isUpper: false });
    expect(shown(below)).toBe(`${ROBOT}while True:\n    left()\n    stop()\n    forward()|`);
  });

  it('is one step to undo, with its import', () => {
    let state = put(program('print(1)|'), 'clear');
    expect(state.doc.toString()).toBe(`${BOARD}print(1)\ndisplay.clear()`);
    undo({ state, dispatch: (transaction) => void (state = transaction.state) });
    expect(state.doc.toString()).toBe('print(1)');
  });
});
