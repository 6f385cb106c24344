// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { penShapes } from '#editor/tools/tool';

import type { ArenaTool } from './state/course-editor-model';
import { editingPage, fill, keyOn, press, samples, type EditingPage } from '../../app/testing/editing';
import { mountOn, named, setWindow, textOf } from '../../app/testing/mount-on';
import EditorActions from './EditorActions.vue';
import EditorMenu from './EditorMenu.vue';
import ToolOptions from './ToolOptions.vue';
import ToolPalette from './palette/ToolPalette.vue';
import { createSelectionKeys } from '../../pupil/arena/tools/tool-keys';
import type { SelectionActs } from './state/selection-acts';
import { clipText } from '#editor/clip-text';

/** A page with this tool chosen and its options visible. */
async function optionsOf(tool: ArenaTool, objects: Parameters<typeof editingPage>[0] = [], roomPx = 900) {
  const page = await editingPage(objects);
  page.editor.choose(tool);
  const mounted = mountOn(page, ToolOptions, { roomPx });
  const set = () => page.editor.options.value;
  const texts = () => mounted.findAll('button').map((it) => it.attributes('aria-label') ?? it.text());
  return { ...page, mounted, set, texts };
}

/** Opens a card by the name of its button. */
async function openCard(name: string): Promise<void> {
  await press(name);
  await vi.waitFor(() => expect(document.querySelector('.card')).not.toBeNull());
}

/** The text of a field. */
const shownIn = (name: string): string => (named(name, 'input') as HTMLInputElement).value;

/** Picks an entry of an open card, or one of the buttons in a row. */
async function pick(name: string): Promise<void> {
  const all = [...document.querySelectorAll<HTMLElement>('[role="radio"]')];
  all.find((it) => (it.getAttribute('aria-label') ?? textOf(it.querySelector('b'))) === name)!.click();
  await nextTick();
}

describe('the options of a tool', () => {
  it('are called by the tool, and by the kind of zone that is put next', async () => {
    const { mounted, editor } = await optionsOf('pen');
    expect(mounted.attributes('aria-label')).toBe('Einstellungen: Stift');
    editor.choose('zone');
    editor.setOptions({ zone: 'forbidden' });
    await nextTick();
    expect(mounted.attributes('aria-label')).toBe('Einstellungen: Verboten');
  });

  it('leave the name out where there is little room, and in the end the picture', async () => {
    const page = await editingPage();
    page.editor.choose('wall');
    const shown = (roomPx: number) => textOf(mountOn(page, ToolOptions, { roomPx }).find('.tool').element);
    expect(shown(400)).toBe('Wand');
    expect(shown(220)).toBe('');
    expect(mountOn(page, ToolOptions, { roomPx: 214 }).find('.tool').exists()).toBe(false);
  });

  it('set a line’s width, shape and colour: they are of the next line, no step of the course', async () => {
    const { set, steps } = await optionsOf('pen');
    await pick('30 mm breit');
    await openCard('Form: Freihand');
    await pick('Gerade');
    await openCard('Farbe: Schwarz');
    await pick('Grün');
    expect(set()).toMatchObject({ penWidth: 30, penShape: 'straight', penColor: 'green' });
    expect(steps()).toBe(0);
  });

  it('hand nothing to a menu that it has no use for', async () => {
    const warned = vi.spyOn(console, 'warn');
    await optionsOf('pen');
    expect(warned).not.toHaveBeenCalled();
    warned.mockRestore();
  });

  it('tell what a line sensor sees of each colour', async () => {
    await optionsOf('pen');
    await openCard('Farbe: Schwarz');
    const rows = [...document.querySelectorAll('.card .row .what')].map(textOf);
    expect(rows).toHaveLength(11);
    expect(rows[0]).toBe('SchwarzLiniensensor: dunkel');
    expect(rows.filter((text) => text.includes('hell') || text.includes('unsichtbar')).length).toBeGreaterThan(0);
  });

  it('offer the magnet for every shape of a line: the ends of lines attract each other', async () => {
    const { editor, texts } = await optionsOf('pen');
    for (const penShape of penShapes) {
      editor.setOptions({ penShape });
      await nextTick();
      expect(texts()).toContain('Magnet: rastet ein');
    }
    expect(editor.free.value).toBe(false);
    await press('Magnet: rastet ein');
    expect([editor.free.value, named('Magnet: rastet ein').getAttribute('aria-pressed')]).toEqual([true, 'false']);
  });

  it('tell how each shape of a line is drawn', async () => {
    const { set } = await optionsOf('pen', [], 300);
    await openCard('Form: Freihand');
    expect(textOf(document.querySelector('.card'))).toContain('Ecken antippen');
    await pick('Von Ecke zu Ecke');
    expect(set()).toMatchObject({ penShape: 'corners' });
  });

  it.each(['select', 'rotate', 'block', 'wall', 'zone', 'label', 'start'] as const)(
    'have the magnet beside the tool %s, also where there is little room',
    async (tool) => {
      const page = await editingPage();
      page.editor.choose(tool);
      expect(mountOn(page, ToolOptions, { roomPx: 236 }).find('[data-testid=magnet]').exists()).toBe(true);
    },
  );

  it('take a width of one’s own, at most 50 cm; the button then shows it', async () => {
    const { set, texts } = await optionsOf('pen');
    await openCard('Eigene Breite');
    await fill('Eigene Breite', '700');
    expect(set().penWidth).toBe(500);
    await fill('Eigene Breite', '42');
    expect([set().penWidth, texts().includes('Eigene Breite: 42 mm')]).toEqual([42, true]);
  });

  it('lead arrow keys from choice to choice, round and round', async () => {
    const { set, mounted } = await optionsOf('pen');
    const radio = (label: string) => mounted.get<HTMLElement>(`[role="radio"][aria-label="${label}"]`).element;
    await keyOn(radio('20 mm breit'), 'ArrowRight');
    expect([set().penWidth, document.activeElement === radio('30 mm breit')]).toEqual([30, true]);
    await keyOn(radio('30 mm breit'), 'ArrowRight');
    expect(set().penWidth).toBe(15);
    expect(radio('15 mm breit').tabIndex).toBe(0);
    expect(radio('20 mm breit').tabIndex).toBe(-1);
  });

  it('make the eraser spare things, and as wide as one likes', async () => {
    const { set } = await optionsOf('eraser');
    await pick('Nur Linien');
    await pick('60 mm breit');
    expect(set()).toMatchObject({ eraser: 'lines', eraserWidth: 60 });
  });

  it('choose among four blocks and set what one does that moves, how fast, and how long it waits', async () => {
    const { set, texts } = await optionsOf('block');
    expect(texts().some((text) => text.startsWith('Hin und her'))).toBe(false);
    await pick('Fährt selbst');
    await openCard('Was er macht: Hin und her');
    await press('Tempo: mehr');
    await press('Wartezeit: mehr');
    await press('Drehung: mehr');
    expect(set()).toMatchObject({ moverSpeed: 110, moverWait: 0.5, moverSpin: 15 });
    await press('Mit Stacheln');
    await pick('Bewacht');
    expect(set().moverWay).toBe('guards');
    expect(set()).toMatchObject({ block: 'mover', moverSpiked: true });
  });

  it('set a block’s size in cm, by one of three or by numbers', async () => {
    const { set, mounted } = await optionsOf('block');
    const size = () => mounted.get('[aria-label^="Grösse: "]').attributes('aria-label')!;
    await openCard(size());
    await pick('10 × 5 cm');
    expect(set().blockSize).toEqual([100, 50]);
    await nextTick();
    expect(size()).toBe('Grösse: 10 × 5 cm'); // once, not twice
    await openCard(size());
    await fill('Länge', '12.5');
    await fill('Breite', '0.1');
    expect(set().blockSize).toEqual([125, 5]);
  });

  it('set how high a block is, in cm; what is usual for its kind is shown and need not be said', async () => {
    const { set, mounted } = await optionsOf('block');
    const open = () => openCard(mounted.get('[aria-label^="Grösse: "]').attributes('aria-label')!);
    await open();
    expect(shownIn('Höhe')).toBe('6');
    await fill('Höhe', '3');
    expect(set().blockHeight).toBe(30);
    await fill('Höhe', '6');
    expect(set().blockHeight).toBeNull();
    await fill('Höhe', '0.1');
    expect(set().blockHeight).toBe(5);
  });

  it.each([
    ['block', 'blockColor'],
    ['wall', 'wallColor'],
  ] as const)('set the colour of the next %s, or none', async (tool, color) => {
    const { set } = await optionsOf(tool);
    await openCard('Farbe: Keine Farbe');
    await pick('Rot');
    expect(set()[color]).toBe('red');
    await openCard('Farbe: Rot');
    await press('Keine Farbe');
    expect(set()[color]).toBeNull();
  });

  it('set how thick a wall is', async () => {
    const { set } = await optionsOf('wall');
    await openCard('Dicke: 10 mm dick');
    await pick('20 mm dick');
    expect(set().wallThickness).toBe(20);
    await openCard('Dicke: 20 mm dick');
    expect(shownIn('Höhe')).toBe('250');
    await fill('Höhe', '35');
    expect(set().wallHeight).toBe(35);
  });

  it('set how large the cells of a maze are', async () => {
    const { set } = await optionsOf('maze');
    await openCard('Feldgrösse: Felder von 15 cm');
    await fill('Feldgrösse', '25');
    expect(set().mazeCell).toBe(250);
    await fill('Feldgrösse', '1');
    expect(set().mazeCell).toBe(50);
  });

  it('ask for blocks in a target only', async () => {
    const { set, texts } = await optionsOf('zone');
    await openCard('Form: Rechteck');
    await pick('Rund');
    await openCard('Blöcke: 0. Der Roboter muss hin');
    await press('Blöcke: mehr');
    expect(set()).toMatchObject({ zoneShape: 'round', zoneBlocks: 1 });
    expect(texts()).toContain('Blöcke: 1. So viele Blöcke müssen hinein: 1');
    await pick('Verboten');
    expect(texts().some((text) => text.startsWith('Blöcke'))).toBe(false);
  });

  it('hold the words that are written next, and how high they are', async () => {
    const { set } = await optionsOf('label');
    await fill('Text', 'Garage 1');
    await openCard('Höhe: 30 mm hoch');
    await pick('60 mm hoch');
    expect(set()).toMatchObject({ labelText: 'Garage 1', labelHeight: 60 });
  });

  it('point at the field for the words when the arena is tapped before there are any', async () => {
    const { mounted } = await optionsOf('label');
    const arena = document.createElement('div');
    arena.setAttribute('role', 'application');
    document.body.append(arena);
    const tap = () => {
      const more = { bubbles: true, isPrimary: true, button: 0, clientX: 5, clientY: 5 };
      arena.dispatchEvent(new PointerEvent('pointerdown', more));
      arena.dispatchEvent(new PointerEvent('pointerup', more));
      return nextTick();
    };
    await tap();
    expect(mounted.get('[role="status"]').text()).toBe('Schreib zuerst den Text');
    expect(document.activeElement).toBe(named('Text', 'input'));
    await fill('Text', 'Ziel');
    expect(mounted.get('[role="status"]').text()).toBe('');
    await tap();
    expect(mounted.get('[role="status"]').text()).toBe('');
  });

  it('give the field the keyboard once words are put down with the mouse: the next letters are words, too', async () => {
    const { editor } = await optionsOf('label');
    await fill('Text', 'Ziel');
    const arena = document.createElement('div');
    arena.setAttribute('role', 'application');
    arena.tabIndex = 0;
    document.body.append(arena);
    const place = async (id: string, pointerType: string): Promise<void> => {
      arena.focus();
      arena.dispatchEvent(new PointerEvent('pointerup', { bubbles: true, isPrimary: true, button: 0, pointerType }));
      editor.commit({ type: 'add', objects: [{ ...samples.label, id }] });
      await nextTick();
      await nextTick();
    };
    await place('by-finger', 'touch');
    expect(document.activeElement).toBe(arena);
    await place('by-mouse', 'mouse');
    expect(document.activeElement).toBe(named('Text', 'input'));
  });

  it('make the robot larger at its start, up to three times, each time as one step', async () => {
    const { scene, steps, editor } = await optionsOf('start');
    await press('Roboter grösser');
    const once = scene().robot.scale;
    expect(once).toBeGreaterThan(1);
    for (let times = 0; times < 20; times += 1) await press('Roboter grösser');
    expect([scene().robot.scale, (named('Roboter grösser') as HTMLButtonElement).disabled]).toEqual([3, true]);
    const done = steps();
    for (let times = 0; times < done; times += 1) editor.undo();
    expect(scene().robot.scale).toBe(1);
  });

  it('turn the start by 15°, and beyond 180° count from −180°', async () => {
    const { scene } = await optionsOf('start');
    await press('Nach rechts drehen');
    expect(scene().robot.heading).toBe(-15);
    await openCard('Richtung: -15°');
    await fill('Richtung', '175');
    await press('Nach links drehen');
    expect(scene().robot.heading).toBe(-170);
  });

  it('read what the ruler measures in cm and degrees', async () => {
    const { editor, mounted } = await optionsOf('ruler');
    expect(mounted.text()).toContain('Zieh von einem Ort zum andern.');
    editor.measure.value = { from: { x: 100, y: 100 }, to: { x: 400, y: 500 } };
    await nextTick();
    expect(textOf(mounted.get('[data-testid="measure"]').element)).toContain('50.0 cm · 53°');
    expect(textOf(mounted.get('[data-testid="measure"]').element)).toContain('x 30.0 cm · y 40.0 cm');
    editor.measure.value = { from: { x: 400, y: 100 }, to: { x: 100, y: 100 } };
    await nextTick();
    expect(textOf(mounted.get('[data-testid="measure"]').element)).toContain('30.0 cm · 180°');
  });
});

describe('what is selected', () => {
  const selecting = async (ids: readonly string[], tool: ArenaTool = 'select') => {
    const page = await optionsOf(tool, [samples.wall, samples.block]);
    page.editor.select({ ids, robot: false });
    await nextTick();
    return page;
  };

  it('is counted; with nothing selected a hint says how to select', async () => {
    const { mounted, editor } = await selecting([]);
    expect(mounted.text()).toContain('Tippe etwas an oder zieh einen Rahmen.');
    editor.select({ ids: ['block'], robot: false });
    await nextTick();
    expect(mounted.text()).toContain('1 gewählt');
    editor.select({ ids: ['block', 'wall'], robot: true });
    await nextTick();
    expect(mounted.text()).toContain('3 gewählt');
  });

  it('is everything, the start too, with one button', async () => {
    const { editor } = await selecting([]);
    await press('Alles auswählen (Ctrl+A)');
    expect(editor.selection.value).toEqual({ ids: ['wall', 'block'], robot: true });
  });

  it('is doubled, and the copy is selected', async () => {
    const { editor, ids, object } = await selecting(['block']);
    await press('Verdoppeln (Ctrl+D)');
    expect(ids()).toHaveLength(3);
    const copy = ids()[2]!;
    expect(editor.selection.value.ids).toEqual([copy]);
    expect(object('block', copy).size).toEqual([50, 50]);
    expect(object('block', copy).at).not.toEqual(samples.block.at);
  });

  it('is turned by 45° to the left and to the right', async () => {
    const { object } = await selecting(['block']);
    await press('Nach links drehen');
    expect(object('block', 'block').angle).toBe(45);
    await press('Nach rechts drehen');
    await press('Nach rechts drehen');
    expect(object('block', 'block').angle).toBe(315);
  });

  it('is deleted as one step, and selected no more', async () => {
    const { ids, editor, steps } = await selecting(['block', 'wall']);
    await press('Löschen (Delete)');
    expect([ids(), editor.selection.value.ids, steps()]).toEqual([[], [], 1]);
    editor.undo();
    expect(ids()).toEqual(['wall', 'block']);
  });

  it('cannot be doubled or deleted where it is the start of the robot', async () => {
    const { texts, editor } = await selecting([]);
    editor.select({ ids: [], robot: true });
    await nextTick();
    expect(texts()).not.toContain('Löschen (Delete)');
    expect(texts()).not.toContain('Verdoppeln (Ctrl+D)');
    expect(texts()).toContain('Nach links drehen');
  });

  it('opens in the list, to be changed by numbers', async () => {
    const { panels } = await selecting(['block'], 'rotate');
    await press('Mit Zahlen ändern');
    expect(panels.shown.value).toBe('list');
  });
});

describe('the palette', () => {
  const palette = async (form = 'bench') => {
    const page = await editingPage();
    const mounted = mountOn(page, ToolPalette, { form });
    const tool = (id: ArenaTool) => mounted.get<HTMLButtonElement>(`[data-tool="${id}"]`);
    const focused = () => (document.activeElement as HTMLElement).dataset['tool'];
    return { ...page, mounted, tool, focused };
  };

  it('has twelve tools with their letters, of which the hand is pressed first', async () => {
    const { mounted, tool } = await palette();
    const tools = mounted.findAll('[data-tool]');
    expect(tools).toHaveLength(12);
    expect(new Set(tools.map((it) => it.attributes('aria-keyshortcuts'))).size).toBe(12);
    expect(tools.filter((it) => it.attributes('aria-pressed') === 'true')).toHaveLength(1);
    expect(tool('hand').attributes('aria-pressed')).toBe('true');
    expect(tool('pen').attributes('title')).toBe('Stift: Linien auf den Boden malen (P)');
  });

  it('chooses what is clicked', async () => {
    const { tool, editor } = await palette();
    await tool('wall').trigger('click');
    expect([editor.tool.value, tool('wall').attributes('aria-pressed')]).toEqual(['wall', 'true']);
  });

  it('is one stop of the tab key; arrows lead on, Home and End to the ends', async () => {
    const { mounted, tool, focused, editor } = await palette();
    const stops = () => mounted.findAll('[tabindex="0"]').map((it) => it.attributes('data-tool'));
    tool('hand').element.focus();
    await keyOn(tool('hand').element, 'ArrowRight');
    expect([focused(), stops()]).toEqual(['select', ['select']]);
    await keyOn(tool('select').element, 'End');
    expect(focused()).toBe('start');
    await keyOn(tool('start').element, 'ArrowRight');
    expect(focused()).toBe('hand');
    expect(editor.tool.value).toBe('hand'); // arrow keys move without choosing
  });

  it('goes down by a row of two in two columns', async () => {
    const { tool, focused } = await palette('pairs');
    await keyOn(tool('hand').element, 'ArrowDown');
    expect(focused()).toBe('rotate');
    await keyOn(tool('rotate').element, 'ArrowRight');
    expect(focused()).toBe('ruler');
  });

  it('shows names wherever they have room; screen readers hear them always', async () => {
    expect(textOf((await palette('bench')).tool('pen').element)).toBe('Stift');
    document.body.innerHTML = '';
    const { tool, mounted } = await palette('pairs');
    expect([textOf(tool('pen').element), tool('pen').attributes('aria-label')]).toEqual(['', 'Stift']);
    expect(mounted.attributes('aria-orientation')).toBe('vertical');
  });

  it('moves the stop of the tab key along when a letter chooses a tool', async () => {
    const { editor, mounted } = await palette();
    editor.choose('zone');
    await nextTick();
    expect(mounted.get('[tabindex="0"]').attributes('data-tool')).toBe('zone');
  });
});

describe('undo and its keys', () => {
  const acting = async (page?: EditingPage) => {
    const on = page ?? (await editingPage([samples.wall, samples.block]));
    const mounted = mountOn(on, EditorActions);
    const place = document.createElement('div');
    place.setAttribute('data-editor-keys', '');
    place.innerHTML = '<button>Beside the arena</button>';
    document.body.append(place);
    return { ...on, mounted, beside: place.firstElementChild! };
  };
  const removeWall = ({ editor }: Pick<EditingPage, 'editor'>) => editor.commit({ type: 'remove', ids: ['wall'] });
  const control = { ctrlKey: true };

  it('have buttons that can be pressed when there is something to take back or do again', async () => {
    const page = await acting();
    const off = () => [named('Rückgängig (Ctrl+Z)'), named('Wiederholen (Ctrl+Y)')].map((it) => (it as HTMLButtonElement).disabled); // prettier-ignore
    expect(off()).toEqual([true, true]);
    removeWall(page);
    await nextTick();
    expect(off()).toEqual([false, true]);
    await press('Rückgängig (Ctrl+Z)');
    expect([page.ids(), off()]).toEqual([
      ['wall', 'block'],
      [true, false],
    ]);
    await press('Wiederholen (Ctrl+Y)');
    expect(page.ids()).toEqual(['block']);
  });

  it('take back with Ctrl+Z and do again with Ctrl+Y or Ctrl+Shift+Z, on the whole page', async () => {
    const page = await acting();
    removeWall(page);
    expect((await keyOn(document.body, 'z', control)).defaultPrevented).toBe(true);
    expect(page.ids()).toEqual(['wall', 'block']);
    await keyOn(document.body, 'y', control);
    expect(page.ids()).toEqual(['block']);
    await keyOn(document.body, 'z', { metaKey: true });
    await keyOn(document.body, 'Z', { ctrlKey: true, shiftKey: true });
    expect(page.ids()).toEqual(['block']);
  });

  it.each(['<input>', '<textarea></textarea>', '<div role="menu"><b></b></div>', '<div role="dialog"><b></b></div>'])(
    'leave Ctrl+Z to %s',
    async (html) => {
      const page = await acting();
      removeWall(page);
      document.body.insertAdjacentHTML('beforeend', html);
      const outer = document.body.lastElementChild!;
      const event = await keyOn(outer.firstElementChild ?? outer, 'z', control);
      expect([page.ids(), event.defaultPrevented]).toEqual([['block'], false]);
    },
  );

  it('take back in the editor’s own windows, too', async () => {
    const page = await acting();
    removeWall(page);
    document.body.insertAdjacentHTML('beforeend', '<div role="dialog"><div data-editor-window><b></b></div></div>');
    await keyOn(document.querySelector('[data-editor-window] b')!, 'z', control);
    expect(page.ids()).toEqual(['wall', 'block']);
  });

  it('choose tools by letters, but only beside the arena and with the tools in sight', async () => {
    const { editor, beside, mode } = await acting();
    await keyOn(document.body, 'p');
    expect(editor.tool.value).toBe('hand');
    await keyOn(beside, 'p');
    expect(editor.tool.value).toBe('pen');
    await keyOn(beside, 'w', { shiftKey: true });
    await keyOn(beside, 'w', { altKey: true });
    await keyOn(beside, 'q');
    expect(editor.tool.value).toBe('pen');
    mode.enter('drive');
    await nextTick();
    await keyOn(beside, 'p');
    expect(editor.tool.value).toBe('hand');
  });
});

describe('the keys for what is selected, after a press beside the arena', () => {
  const control = { ctrlKey: true };

  /** The page with the block selected, used in the arena, then in a place of this kind. */
  async function selecting(place: string) {
    const page = await editingPage([samples.wall, samples.block]);
    mountOn(page, EditorActions);
    page.editor.choose('select');
    page.editor.select({ ids: ['block'], robot: false });
    document.body.insertAdjacentHTML(
      'beforeend',
      `<div class="pane-arena pane"></div><div class="there">${place}</div>`,
    );
    const use = (css: string) =>
      document.querySelector(css)!.dispatchEvent(new Event('pointerdown', { bubbles: true }));
    use('.pane-arena');
    use('.there > *');
    const key = (name: string, more: KeyboardEventInit = {}) =>
      keyOn(document.querySelector('.there > *')!, name, more);
    return { ...page, key, selected: () => page.editor.selection.value.ids };
  }

  it('group it with Ctrl+G, and dissolve the group with Shift', async () => {
    const { key, object, editor, steps } = await selecting('<button>Save</button>');
    editor.select({ ids: ['wall', 'block'], robot: false });
    expect((await key('g', control)).defaultPrevented).toBe(true); // the browser does not search
    await vi.waitFor(() => expect(object('wall', 'wall').group).toBe('group-1'));
    await key('G', { ...control, shiftKey: true });
    await vi.waitFor(() => expect([object('wall', 'wall').group, steps()]).toEqual([undefined, 2]));
  });

  it.each(['<button>Save</button>', '<div class="pane"><button>LED</button></div>'])(
    'duplicate, copy, paste and remove it: %s',
    async (place) => {
      const { key, ids, editor } = await selecting(place);
      expect((await key('d', control)).defaultPrevented).toBe(true); // no bookmark
      await vi.waitFor(() => expect(ids()).toHaveLength(3));
      await key('c', control);
      await vi.waitFor(() => expect(editor.clipboard.isEmpty).toBe(false));
      await key('v', { metaKey: true });
      await vi.waitFor(() => expect(ids()).toHaveLength(4));
      await key('Delete');
      await vi.waitFor(() => expect(ids()).toHaveLength(3));
      await key('z', control);
      expect(ids()).toHaveLength(4);
    },
  );

  it('move it with the arrows, as one step, and the arena has the keyboard then', async () => {
    const { key, object, steps, editor, scene } = await selecting('<button>Save</button>');
    const context = () => ({ scene: scene(), selection: editor.selection.value, options: editor.options.value, footprint: [] }); // prettier-ignore
    const keys = createSelectionKeys({
      context,
      commit: editor.commit,
      acts: {} as SelectionActs,
      pointed: () => null,
      changed: () => undefined,
    });
    document.querySelector('.pane-arena')!.innerHTML = '<div role="application" tabindex="0"></div>';
    const arena = document.querySelector<HTMLElement>('[role="application"]')!;
    arena.addEventListener('keydown', (event) => keys.keyDown(event.key, event.shiftKey, false) && event.preventDefault()); // prettier-ignore
    expect((await key('ArrowRight')).defaultPrevented).toBe(true);
    expect(document.activeElement).toBe(arena);
    keys.keyDown('ArrowRight', false, false);
    keys.keyUp('ArrowRight');
    expect([object('block', 'block').at[0], steps()]).toEqual([samples.block.at[0] + 20, 1]);
  });

  it('leave the arrows to what moves by them', async () => {
    const { key } = await selecting('<div role="radiogroup"><button>5 mm</button></div>');
    expect((await key('ArrowRight')).defaultPrevented).toBe(false);
  });

  it('give the system’s clipboard a text, and paste that of another tab at the pointer', async () => {
    const { key, ids, editor, object } = await selecting('<button>Save</button>');
    await vi.dynamicImportSettled();
    await key('c', control);
    const given = new Map<string, string>();
    const clipboard = (name: string, text: string) => {
      const clipboardData = {
        files: [],
        getData: () => text,
        setData: (kind: string, is: string) => given.set(kind, is),
      };
      const event = Object.assign(new Event(name, { bubbles: true, cancelable: true }), { clipboardData });
      document.body.dispatchEvent(event);
      return event.defaultPrevented;
    };
    expect(clipboard('copy', '')).toBe(true);
    expect(given.get('text/plain')).toContain('parcours-objects');
    const other = clipText({ objects: [{ ...samples.block, size: [80, 80] }] });
    editor.pointer.value = { x: 900, y: 700 };
    await key('v', control);
    expect(clipboard('paste', other)).toBe(true);
    await vi.waitFor(() => expect(ids()).toHaveLength(3));
    expect(object('block', ids()[2]!)).toMatchObject({ at: [900, 700], size: [80, 80] });
  });

  it('paste nothing of a text from elsewhere, and say so; a picture is offered as the floor', async () => {
    const { ids, notices, panels, key } = await selecting('<button>Save</button>');
    const offered = vi.spyOn(panels, 'offer').mockReturnValue(true);
    const paste = async (text: string, files: readonly File[]) => {
      await key('v', control);
      const clipboardData = { files, getData: () => text };
      document.body.dispatchEvent(Object.assign(new Event('paste', { bubbles: true, cancelable: true }), { clipboardData })); // prettier-ignore
    };
    await paste('from microbit import *', []);
    await vi.waitFor(() => expect(notices.current.value?.values?.['text']).toContain('Zwischenablage'));
    const picture = new File(['x'], 'plan.png', { type: 'image/png' });
    await paste('', [picture]);
    expect([offered.mock.calls, ids()]).toEqual([[[picture]], ['wall', 'block']]);
  });

  it('cut it, and paste it although nothing is selected then', async () => {
    const { key, ids } = await selecting('<button>Save</button>');
    await key('x', control);
    await vi.waitFor(() => expect(ids()).toEqual(['wall']));
    await key('v', control);
    await vi.waitFor(() => expect(ids()).toHaveLength(2));
  });

  it('select all where the arena was used last', async () => {
    const { key, selected } = await selecting('<button>Save</button>');
    expect((await key('a', control)).defaultPrevented).toBe(true);
    await vi.waitFor(() => expect(selected()).toEqual(['wall', 'block']));
  });

  it('take all away when Delete follows Ctrl+A at once', async () => {
    const { key, ids, editor } = await selecting('<button>Save</button>');
    editor.select({ ids: [], robot: false });
    void key('a', control);
    expect((await key('Delete')).defaultPrevented).toBe(true);
    await vi.waitFor(() => expect(ids()).toEqual([]));
  });

  it('let go of it with Escape', async () => {
    const { key, selected } = await selecting('<button>Save</button>');
    expect((await key('Escape')).defaultPrevented).toBe(true);
    expect(selected()).toEqual([]);
  });

  it('leave Escape to a menu that is open', async () => {
    const { key, selected } = await selecting('<button aria-expanded="true">Shape</button>');
    await key('Escape');
    expect(selected()).toEqual(['block']);
  });

  it('leave Ctrl+A to another pane that was used since', async () => {
    const { key } = await selecting('<div class="pane"></div>');
    expect((await key('a', control)).defaultPrevented).toBe(false);
  });

  it.each([
    '<input>',
    '<div class="pane pane-console"></div>',
    '<div role="dialog"></div>',
    '<div contenteditable="true"></div>',
  ])('stay with %s', async (place) => {
    const { key, ids } = await selecting(place);
    for (const name of ['a', 'c', 'd', 'v', 'x']) expect((await key(name, control)).defaultPrevented).toBe(false);
    expect((await key('Delete')).defaultPrevented).toBe(false);
    expect(ids()).toEqual(['wall', 'block']);
  });

  it('stay with the browser where nothing is selected', async () => {
    const { key, editor } = await selecting('<button>Save</button>');
    editor.select({ ids: [], robot: false });
    for (const name of ['c', 'd', 'v', 'x']) expect((await key(name, control)).defaultPrevented).toBe(false);
    expect((await key('Delete')).defaultPrevented).toBe(false);
  });

  it('leave words that are marked on the page to be copied', async () => {
    const { key } = await selecting('<p>words</p>');
    vi.spyOn(window, 'getSelection').mockReturnValue({ isCollapsed: false } as Selection);
    expect((await key('c', control)).defaultPrevented).toBe(false);
  });
});

describe('undo over a reload', () => {
  beforeEach(() => sessionStorage.clear());
  afterEach(() => sessionStorage.clear());
  const KEY = 'parcours.undo';

  /** Another page with the same work, as after a reload. */
  const reload = async (page: EditingPage) => {
    const next = await editingPage();
    next.work.setScene(page.scene(), null);
    next.mode.enter('build');
    mountOn(next, EditorActions);
    return next;
  };

  it('takes back what was done before, and does it again', async () => {
    const page = await editingPage([samples.wall, samples.block]);
    mountOn(page, EditorActions);
    page.editor.commit({ type: 'remove', ids: ['wall'] });
    await vi.dynamicImportSettled();
    dispatchEvent(new Event('pagehide'));
    expect(sessionStorage.getItem(KEY)).not.toBeNull();
    const next = await reload(page);
    await vi.waitFor(() => expect(next.steps()).toBe(1));
    next.editor.undo();
    expect(next.ids()).toEqual(['wall', 'block']);
    next.editor.redo();
    expect(next.ids()).toEqual(['block']);
  });

  it('begins anew where the course is another one meanwhile', async () => {
    const page = await editingPage([samples.wall]);
    mountOn(page, EditorActions);
    page.editor.commit({ type: 'remove', ids: ['wall'] });
    await vi.dynamicImportSettled();
    dispatchEvent(new Event('pagehide'));
    const next = await editingPage([samples.spikes]);
    mountOn(next, EditorActions);
    await vi.dynamicImportSettled();
    expect([next.steps(), next.ids()]).toEqual([0, ['spikes']]);
  });

  it('is not troubled by what it cannot read', async () => {
    sessionStorage.setItem(KEY, '{"past":');
    const page = await editingPage([samples.wall]);
    mountOn(page, EditorActions);
    await vi.dynamicImportSettled();
    page.editor.commit({ type: 'remove', ids: ['wall'] });
    page.editor.undo();
    expect(page.ids()).toEqual(['wall']);
  });
});

describe('the menu of the course', () => {
  const menu = async (objects: Parameters<typeof editingPage>[0] = [samples.wall, samples.block]) => {
    const page = await editingPage(objects);
    const mounted = mountOn(page, EditorMenu);
    const item = (id: string) => mounted.get<HTMLElement>(`[data-testid="editor-${id}"]`);
    return { ...page, mounted, item };
  };

  it.each(['list', 'course', 'background', 'print'] as const)('opens the window: %s', async (panel) => {
    const { panels, item } = await menu();
    await item(panel).trigger('click');
    expect(panels.shown.value).toBe(panel);
    panels.close();
    expect(panels.shown.value).toBeNull();
  });

  it('clears the course without a question, and offers to take it back', async () => {
    const { item, ids, notices } = await menu();
    await item('clear').trigger('click');
    expect(ids()).toEqual([]);
    const notice = notices.current.value!;
    expect(notice.key).toBe('notice.cleared');
    notice.action!.run();
    expect(ids()).toEqual(['wall', 'block']);
  });

  it('has nothing to clear in an empty course', async () => {
    const { item, steps } = await menu([]);
    expect(item('clear').classes()).toContain('page-list-item--disabled');
    await item('clear').trigger('click');
    expect(steps()).toBe(0);
  });

  it('hides the arena, but on a phone, where it has a tab of its own', async () => {
    const { mounted, settings } = await menu();
    await press('Arena ausblenden', '[role="menuitem"]');
    expect(settings.current.value.showArena).toBe(false);
    expect(mounted.findAll('[role="menuitem"]')).toHaveLength(8);
    setWindow(400);
    expect((await menu()).mounted.findAll('[role="menuitem"]')).toHaveLength(7);
  });
});
