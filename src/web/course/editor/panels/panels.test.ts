// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import type { SceneObject } from '#scene/scene';

import { editingPage, fill, keyOn, press, samples } from '../../../app/testing/editing';
import { mountOn, named, textOf } from '../../../app/testing/mount-on';
// Loaded up front, so that no test's time includes loading it.
import '../background/read-image';
import BackgroundSettings from './BackgroundSettings.vue';
import CourseSettings from './CourseSettings.vue';
import ObjectList from './ObjectList.vue';

const field = (name: string) => named(name, 'input, textarea, select') as HTMLInputElement;

describe('the settings of a course', () => {
  const settings = async (...given: Parameters<typeof editingPage>) => {
    const page = await editingPage(...given);
    return { ...page, mounted: mountOn(page, CourseSettings) };
  };

  it('give it a name, as one step that can be taken back', async () => {
    const { scene, editor, steps } = await settings();
    await fill('Name', '  Um die Ecke ');
    expect([scene().name, steps()]).toEqual(['Um die Ecke', 1]);
    editor.undo();
    await nextTick();
    expect([scene().name, field('Name').value]).toEqual(['', '']);
  });

  it('leave a course without a name when its task is written: “unnamed” is no name', async () => {
    const { scene } = await settings();
    expect([field('Name').value, field('Name').placeholder]).toEqual(['', 'Ohne Namen']);
    await fill('Aufgabe', 'Fahr herum.');
    expect(scene()).toMatchObject({ name: '', description: 'Fahr herum.' });
  });

  it('make no step of a name that is the same', async () => {
    const { steps } = await settings([], { name: 'Kurve' });
    await fill('Name', 'Kurve ');
    expect(steps()).toBe(0);
  });

  it('keep the task when the course gets another name, and the name when it gets another task', async () => {
    const { scene } = await settings([], { name: 'Kurve', description: 'Fahr ins Ziel.' });
    await fill('Name', 'Schleife');
    expect(scene()).toMatchObject({ name: 'Schleife', description: 'Fahr ins Ziel.' });
    await fill('Aufgabe', 'Fahr zweimal herum.');
    expect(scene()).toMatchObject({ name: 'Schleife', description: 'Fahr zweimal herum.' });
  });

  it('have the whole task in one place: title, hints one after the other, what is allowed, stars', async () => {
    const { scene, mounted } = await settings([], { name: 'Kurve', description: 'Fahr ins Ziel.' });
    await fill('Titel der Aufgabe', 'Um die Ecke');
    await press('Tipp hinzufügen');
    await nextTick();
    expect(document.activeElement).toBe(field('Tipp 1')); // what is typed next goes there
    await fill('Tipp 1', 'Langsam.');
    await press('Tipp hinzufügen');
    await nextTick();
    expect(document.activeElement).toBe(field('Tipp 2'));
    await fill('Tipp 2', 'Noch langsamer.');
    await mounted.get('[data-testid="allow-hand"]').setValue(true);
    await mounted.get('[data-testid="give-stars"]').setValue(true);
    expect(scene()).toMatchObject({ name: 'Kurve', description: 'Fahr ins Ziel.' });
    expect(scene().task).toMatchObject({
      ...{ allows: ['hand'], stars: [30, 20] },
      card: { title: 'Um die Ecke', hints: ['Langsam.', 'Noch langsamer.'], language: '', translations: [] },
    });
    await fill('Tipp 1', '');
    expect(scene().task.card?.hints).toEqual(['Noch langsamer.']);
  });

  it('show the text as pupils read it', async () => {
    const { mounted } = await settings([], {
      description: 'Fahr **los**.\n\n- eins\n- zwei\n\n<img src=x onerror=alert(1)>',
    });
    const preview = mounted.get('[data-testid="task-preview"]');
    expect([preview.get('strong').text(), preview.findAll('li').length]).toEqual(['los', 2]);
    expect(preview.find('img').exists()).toBe(false);
  });

  it('write the task in several languages, each at its place', async () => {
    const { scene } = await settings([], { name: 'Kurve', description: 'Fahr los.' });
    await press('Weitere Sprachen');
    expect(document.activeElement?.textContent.trim()).toBe('Deutsch'); // the button is gone
    await press('Français', '.presets button');
    expect(field('Aufgabe').value).toBe('');
    await fill('Aufgabe', 'Démarre.');
    expect(scene()).toMatchObject({ description: 'Fahr los.' });
    expect(scene().task.card).toMatchObject({
      language: 'de',
      translations: [{ language: 'fr', title: '', text: 'Démarre.', hints: [] }],
    });
    await press('Deutsch', '.presets button');
    expect(field('Aufgabe').value).toBe('Fahr los.');
  });

  it('keep the solution of a ready course back, or show it', async () => {
    const { scene, work, mounted } = await settings();
    expect(mounted.find('[data-testid="allow-solution"]').exists()).toBe(false);
    work.setScene({ ...scene(), name: 'x' }, 'slalom');
    await nextTick();
    const box = () => mounted.get<HTMLInputElement>('[data-testid="allow-solution"]');
    expect(box().element.checked).toBe(true);
    await box().trigger('change');
    expect(scene().task.card?.solution).toBe(false);
    await box().trigger('change');
    expect(scene().task.card?.solution).toBe(true);
  });

  it('offer five sizes in cm and press the one that it has', async () => {
    const { mounted, scene, steps } = await settings();
    const pressed = () => mounted.findAll('.presets button').map((it) => it.attributes('aria-pressed'));
    expect(mounted.findAll('.presets button').map((it) => it.text())).toEqual([
      ...['60 × 40 cm', '80 × 60 cm', '120 × 90 cm', '200 × 150 cm', '300 × 200 cm'],
    ]);
    expect(pressed()).toEqual(['false', 'false', 'true', 'false', 'false']);
    await press('80 × 60 cm', '.presets button');
    expect([scene().size, pressed()[1], steps()]).toEqual([[800, 600], 'true', 1]);
    await press('80 × 60 cm', '.presets button');
    expect(steps()).toBe(1);
  });

  it('take any width and height in cm, none beyond 20 cm and 10 m', async () => {
    const { scene } = await settings();
    await fill('Breite', '95.5');
    expect(scene().size).toEqual([955, 900]);
    await fill('Höhe', '1');
    expect(scene().size).toEqual([955, 200]);
    await fill('Breite', '99999');
    expect(scene().size).toEqual([10_000, 200]);
  });

  it('limit the time: a minute at first, then what is set, and no time at all again', async () => {
    const { scene, mounted, steps } = await settings();
    expect(mounted.find('[role="spinbutton"][aria-valuemax="3600"]').exists()).toBe(false);
    await mounted.get('[data-testid="time-limit"]').setValue(true);
    expect(scene().task.seconds).toBe(60);
    await press('Sekunden: mehr');
    expect(scene().task.seconds).toBe(65);
    await fill('Sekunden', '5000');
    expect(scene().task.seconds).toBe(3600);
    expect((named('Sekunden: mehr') as HTMLButtonElement).disabled).toBe(true);
    await mounted.get('[data-testid="time-limit"]').setValue(false);
    expect([scene().task.seconds, steps()]).toEqual([null, 4]);
  });

  it('set the light of the room where a lamp or a tunnel is', async () => {
    expect((await settings([])).mounted.find('[data-testid="room-light"]').exists()).toBe(false);
    const { scene } = await settings([samples.lamp]);
    await fill('Licht im Raum', '0');
    expect(scene().ambient).toBe(0);
    await fill('Licht im Raum', '300');
    expect(scene()).not.toHaveProperty('ambient');
  });

  it('forbid to touch anything, and leave the time as it is', async () => {
    const { scene, mounted } = await settings([], { task: { seconds: 30, noTouch: false } });
    await mounted.get('[data-testid="no-touch"]').setValue(true);
    expect(scene().task).toEqual({ seconds: 30, noTouch: true });
  });

  it('say how several robots share the task, and leave the rest of it as it is', async () => {
    const { scene, mounted } = await settings([], { task: { seconds: 30, noTouch: false, stars: [20, 10] } });
    const sharing = mounted.get<HTMLSelectElement>('[data-testid="sharing"]');
    expect(sharing.element.value).toBe('');
    await sharing.setValue('ring');
    expect(scene().task).toEqual({ seconds: 30, noTouch: false, stars: [20, 10], robots: 'ring' });
    await sharing.setValue('');
    expect(scene().task).toEqual({ seconds: 30, noTouch: false, stars: [20, 10] });
  });

  it('follow the course when a step is taken back beside them', async () => {
    const { editor, scene } = await settings();
    await fill('Breite', '50');
    editor.undo();
    await nextTick();
    expect([field('Breite').value, scene().size]).toEqual(['120', [1200, 900]]);
  });

  it('have a number that arrow keys change by 10 cm, and that nonsense leaves as it was', async () => {
    const { scene, steps } = await settings();
    const used = await keyOn(field('Breite'), 'ArrowUp');
    expect([scene().size[0], used.defaultPrevented]).toEqual([1300, true]);
    await keyOn(field('Breite'), 'ArrowDown');
    await keyOn(field('Breite'), 'ArrowDown');
    expect(scene().size[0]).toBe(1100);
    await fill('Breite', 'breit');
    expect([scene().size[0], field('Breite').value, steps()]).toEqual([1100, '110', 3]);
  });

  it('tell screen readers a number with its unit and its bounds', async () => {
    await settings();
    const width = field('Breite');
    expect(['now', 'min', 'max', 'text'].map((it) => width.getAttribute(`aria-value${it}`))).toEqual([
      ...['120', '20', '1000', '120 cm'],
    ]);
  });
});

/** The list of objects, and what it shows. */
async function list(objects: readonly SceneObject[], more: Parameters<typeof editingPage>[1] = {}) {
  const page = await editingPage(objects, more);
  const mounted = mountOn(page, ObjectList);
  const rows = () => mounted.findAll('.item[data-id] b').map((it) => it.text());
  const row = (id: string) => mounted.get<HTMLButtonElement>(`[data-id="${id}"]`);
  const open = (id: string) => row(id).trigger('click');
  return { ...page, mounted, rows, row, open };
}

describe('the list of objects', () => {
  it('says when nothing is in the arena; the start is there all the same', async () => {
    const { mounted, rows } = await list([]);
    expect(rows()).toEqual([]);
    expect(mounted.get('.none').text()).toBe('Noch liegt nichts in der Arena.');
    expect(textOf(mounted.get('[data-robot]').element)).toContain('60 | 45 cm, 0°');
  });

  it('calls each kind by its name, with its place in cm', async () => {
    const { rows, row } = await list(Object.values(samples));
    expect(rows()).toEqual([
      ...['Linie 1', 'Wand 1', 'Block 1', 'Fester Block 1', 'Stacheln 1', 'Fahrender Block 1'],
      ...[
        'Ziel 1',
        'Kontrollpunkt 1',
        'Verbotenes Feld 1',
        'Farbfeld 1',
        'Lampe 1',
        'Schranke 1',
        'Tunnel 1',
        'AprilTag 7',
      ],
      ...['Text «Hallo»', 'Start eines Roboters «Ada»'],
    ]);
    expect(row('wall').get('.num').text()).toBe('von 10 | 10 bis 30 | 10 cm · 10 mm dick');
    expect(row('mover').get('.num').text()).toBe('90 | 40 ↔ 110 | 40 cm · 10 cm/s');
    expect(row('label').get('.num').text()).toBe('bei 50 | 80 cm');
  });

  it('selects in the arena what is opened, and nothing when it is closed', async () => {
    const { editor, open, row } = await list([samples.wall, samples.block]);
    await open('block');
    expect([editor.tool.value, editor.selection.value.ids]).toEqual(['select', ['block']]);
    expect([row('block').attributes('aria-expanded'), row('wall').attributes('aria-expanded')]).toEqual([
      ...['true', 'false'],
    ]);
    await open('block');
    expect(editor.selection.value.ids).toEqual([]);
  });

  it('opens what is selected in the arena meanwhile', async () => {
    const { editor, row, mounted } = await list([samples.wall]);
    editor.select({ ids: ['wall'], robot: false });
    await nextTick();
    expect(row('wall').attributes('aria-expanded')).toBe('true');
    expect(mounted.findAll('.detail')).toHaveLength(1);
  });

  it('begins with the keyboard at what is selected', async () => {
    const page = await editingPage([samples.wall, samples.block]);
    page.editor.choose('select');
    page.editor.select({ ids: ['block'], robot: false });
    mountOn(page, ObjectList);
    await nextTick();
    expect((document.activeElement as HTMLElement).dataset['id']).toBe('block');
  });

  it('tells of each thing where it is, what it looks like and what it wants', async () => {
    const wanting = { ...samples.target, blocks: 2, angle: 45 } as const;
    const low = { ...samples.block, height: 30, angle: 15 } as const;
    const { mounted } = await list([samples.stroke, samples.wall, wanting, samples.mover, low]);
    const told = mounted.findAll('li .num').map((it) => it.text());
    expect(told.slice(1)).toEqual([
      'von 10 | 80 bis 30 | 80 cm · Schwarz, 20 mm breit',
      'von 10 | 10 bis 30 | 10 cm · 10 mm dick',
      '15 × 15 cm bei 90 | 70 cm · So viele Blöcke müssen hinein: 2, Gedreht 45°',
      '90 | 40 ↔ 110 | 40 cm · 10 cm/s',
      '5 × 5 cm bei 40 | 20 cm · 30 mm hoch, Gedreht 15°',
    ]);
  });

  it('shows what is locked with a lock, and offers to unlock it instead of changing it', async () => {
    const { mounted, row, open, object, steps } = await list([samples.wall, samples.block]);
    await open('block');
    await press('Block 1 sperren');
    expect([object('block', 'block').lock, steps()]).toEqual([true, 1]);
    expect(row('block').get('[role="img"]').attributes('aria-label')).toBe('gesperrt');
    expect(row('wall').find('[role="img"]').exists()).toBe(false);
    expect(mounted.findAll('.detail input, .detail .remove')).toHaveLength(0);
    await press('Block 1 entsperren');
    expect([object('block', 'block').lock, steps()]).toEqual([undefined, 2]);
    expect(mounted.findAll('.detail .remove')).toHaveLength(1);
  });

  it('says which things are one group', async () => {
    const inGroup = { group: 'g' };
    const { row } = await list([{ ...samples.wall, ...inGroup }, { ...samples.block, ...inGroup }, samples.target]);
    expect(['wall', 'block'].map((id) => row(id).get('.num').text().endsWith(' · Gruppe 1'))).toEqual([true, true]);
    expect(row('target').get('.num').text()).not.toContain('Gruppe');
  });

  it('leads from row to row with the arrow keys, and takes away what the keyboard is at with Delete', async () => {
    const { row, ids, editor } = await list([samples.wall, samples.block, samples.target]);
    (row('wall').element as HTMLElement).focus();
    const at = (): string | undefined => (document.activeElement as HTMLElement).dataset['id'];
    await keyOn(row('wall').element, 'ArrowDown');
    expect(at()).toBe('block');
    await keyOn(row('block').element, 'End');
    expect(at()).toBe('target');
    await keyOn(row('target').element, 'ArrowUp');
    await keyOn(row('block').element, 'Delete');
    await nextTick();
    expect([ids(), at()]).toEqual([['wall', 'target'], 'target']);
    editor.undo();
    expect(ids()).toEqual(['wall', 'block', 'target']);
  });

  it('moves the end of a wall, and refuses to make it a wall without length', async () => {
    const { open, object, steps } = await list([samples.wall]);
    await open('wall');
    await fill('Ende x', '40');
    expect(object('wall', 'wall').to).toEqual([400, 100]);
    await fill('Ende x', '10');
    expect([object('wall', 'wall').to, steps()]).toEqual([[400, 100], 1]);
  });

  it('keeps a thickness within 0.2 and 50 cm', async () => {
    const { open, object } = await list([samples.wall]);
    await open('wall');
    await fill('Dicke', '0');
    expect(object('wall', 'wall').thickness).toBe(2);
    await fill('Dicke', '77');
    expect(object('wall', 'wall').thickness).toBe(500);
  });

  it('makes a block that can be pushed a fixed one, in the same place', async () => {
    const { open, object, mounted } = await list([samples.block]);
    await open('block');
    const kind = mounted.get<HTMLSelectElement>('select');
    expect(kind.findAll('option').map((it) => it.text())).toEqual(['Beweglich', 'Fest', 'Stacheln']);
    await kind.setValue('fixed-block');
    expect(object('fixed-block', 'block')).toMatchObject({ at: [400, 200], size: [50, 50] });
  });

  it('makes a target round, and a zone that is not to be entered', async () => {
    const { open, object, mounted } = await list([samples.target]);
    await open('target');
    const [, shape] = mounted.findAll('.detail select');
    await shape?.setValue('round');
    expect(object('target', 'target').round).toBe(true);
    await mounted.get('select').setValue('forbidden');
    expect(object('forbidden', 'target').round).toBe(true);
  });

  it('gives the other checkpoint the number that this one had', async () => {
    const two = { ...samples.checkpoint, id: 'two', at: [400, 300], number: 2 } as const;
    const { open, object, editor, rows } = await list([samples.checkpoint, two]);
    await open('two');
    await fill('Nummer', '1');
    expect([object('checkpoint', 'one').number, object('checkpoint', 'two').number]).toEqual([2, 1]);
    expect(rows()).toEqual(['Kontrollpunkt 2', 'Kontrollpunkt 1']);
    editor.undo();
    expect([object('checkpoint', 'one').number, object('checkpoint', 'two').number]).toEqual([1, 2]);
  });

  it('writes another text on the floor, but not an empty one', async () => {
    const { open, object, steps } = await list([samples.label]);
    await open('label');
    await fill('Text', 'Garage');
    expect(object('label', 'label').text).toBe('Garage');
    await fill('Text', '   ');
    expect([object('label', 'label').text, steps()]).toEqual(['Garage', 1]);
  });

  it('makes a block a polygon, and turns it to a tenth of a degree', async () => {
    const { open, object, mounted } = await list([samples.block]);
    await open('block');
    await fill('Gedreht', '12,5');
    expect(object('block', 'block').angle).toBe(12.5);
    const [, shape] = mounted.findAll('.detail select');
    await shape?.setValue('polygon');
    expect(object('block', 'block').corners).toHaveLength(3);
    await shape?.setValue('rectangle');
    expect(object('block', 'block')).not.toHaveProperty('corners');
  });

  it('has the stops of a mover as numbers, adds one and takes one out', async () => {
    const { open, object, row } = await list([samples.mover]);
    await open('mover');
    await press('Halt hinzufügen');
    expect(object('mover', 'mover').stops).toEqual([[1100, 600]]);
    await fill('Halt 3: y', '70');
    await fill('Halt 2: Wartezeit', '1.5');
    expect(object('mover', 'mover')).toMatchObject({ stops: [[1100, 700]], waits: [0, 1.5] });
    expect(row('mover').get('.num').text()).toContain('90 | 40 ↔ 110 | 70 cm, 3 Halte');
    await press('Halt 1 entfernen');
    expect(object('mover', 'mover')).toMatchObject({ at: [1100, 400], to: [1100, 700], waits: [1.5] });
    expect((named('Halt 1 entfernen') as HTMLButtonElement).disabled).toBe(true);
  });

  it('chooses the field that a guard watches', async () => {
    const { open, object, row, mounted } = await list([samples.mover, samples.target, samples.checkpoint]);
    await open('mover');
    await mounted.get('select').setValue('guards');
    expect(object('mover', 'mover').chases).toEqual({ zone: 'target' });
    await mounted.get('[data-testid="guarded-zone"]').setValue(samples.checkpoint.id);
    expect(object('mover', 'mover').chases).toEqual({ zone: samples.checkpoint.id });
    expect(row('mover').get('.num').text()).toContain('bei 90 | 40 cm, bewacht ein Feld');
    await fill('Bemerkt bis (0: überall)', '50');
    expect(object('mover', 'mover').chases).toEqual({ zone: samples.checkpoint.id, reach: 500 });
  });

  it('sets the tempo of a mover in cm/s, and gives it spikes', async () => {
    const { open, object, mounted } = await list([samples.mover]);
    await open('mover');
    await fill('Tempo', '25');
    expect(object('mover', 'mover').speed).toBe(250);
    await fill('Tempo', '100');
    expect(object('mover', 'mover').speed).toBe(500);
    await mounted.get('.detail input[type="checkbox"]').trigger('change');
    expect(object('mover', 'mover').spiked).toBe(true);
  });

  it('paints a line in another colour', async () => {
    const { open, object, mounted } = await list([samples.stroke]);
    await open('line');
    await mounted.get('select').setValue('red');
    expect(object('stroke', 'line').color).toBe('red');
    await fill('Strichbreite', '3.5');
    expect(object('stroke', 'line').width).toBe(35);
  });

  it('places, turns and scales the robot where it starts', async () => {
    const { mounted, scene, editor } = await list([]);
    await mounted.get('[data-robot]').trigger('click');
    expect(editor.selection.value).toEqual({ ids: [], robot: true });
    await fill('x', '40');
    await fill('Richtung', '90');
    await fill('Grösse', '1.5');
    expect(scene().robot).toMatchObject({ at: [400, 450], heading: 90, scale: 1.5 });
  });

  it('keeps the whole robot inside the arena', async () => {
    const { mounted, scene } = await list([]);
    await mounted.get('[data-robot]').trigger('click');
    await fill('x', '500');
    expect(scene().robot.at[0]).toBeLessThan(1200);
    expect(scene().robot.at[0]).toBeGreaterThan(1000);
  });

  it('adds each kind without a pointer, as one step and in a place of its own, and opens it', async () => {
    const { scene, editor, steps, mounted, rows, ids } = await list([]);
    const kinds = Object.keys(samples);
    for (const [at, kind] of kinds.entries()) {
      await mounted.get('[data-testid="add-object"]').trigger('click');
      document.querySelector<HTMLElement>(`.page-overlay--active [data-testid="add-${kind}"]`)!.click();
      await nextTick();
      expect([steps(), scene().objects[at]?.type, editor.selection.value.ids]).toEqual([at + 1, kind, [ids()[at]]]);
    }
    const places = mounted.findAll('.item .num').map((it) => it.text());
    expect([rows().length, new Set(places).size, editor.tool.value]).toEqual([
      ...[kinds.length, kinds.length + 1, 'select'],
    ]);
    editor.undo();
    expect(scene().objects.map(({ type }) => type)).toEqual(kinds.slice(0, -1));
  });

  it('deletes what is open, and the keyboard goes on at what follows', async () => {
    const { open, ids, editor, scene } = await list([samples.wall, samples.block, samples.spikes]);
    await open('block');
    await press('Block 1 löschen');
    await nextTick();
    expect(ids()).toEqual(['wall', 'spikes']);
    expect((document.activeElement as HTMLElement).dataset['id']).toBe('spikes');
    expect(editor.selection.value.ids).toEqual([]);
    editor.undo();
    expect(scene().objects.map(({ id }) => id)).toEqual(['wall', 'block', 'spikes']);
  });

  it('leads the keyboard to the robot when the last thing is deleted', async () => {
    const { open } = await list([samples.wall]);
    await open('wall');
    await press('Wand 1 löschen');
    await nextTick();
    expect((document.activeElement as HTMLElement).hasAttribute('data-robot')).toBe(true);
  });

  it('shows the newest 100 of 120 things, and the others on demand', async () => {
    const many = Array.from({ length: 120 }, (_, i) => ({ ...samples.wall, id: `w${String(i)}` }));
    const { rows, mounted } = await list(many);
    expect([rows().length, rows()[0], rows().at(-1)]).toEqual([100, 'Wand 21', 'Wand 120']);
    await press('Noch 20 zeigen');
    expect([rows().length, rows()[0]]).toEqual([120, 'Wand 1']);
    expect(mounted.text()).not.toContain('zeigen');
  });

  it('adds nothing to a course that is full', async () => {
    const full = Array.from({ length: 2000 }, (_, i) => ({ ...samples.wall, id: `w${String(i)}` }));
    const { ids, steps, mounted } = await list(full);
    await mounted.get('[data-testid="add-object"]').trigger('click');
    await vi.waitFor(() => expect(document.querySelector('[data-testid="add-wall"]')).not.toBeNull());
    document.querySelector<HTMLElement>('[data-testid="add-wall"]')!.click();
    await nextTick();
    expect([ids().length, steps()]).toEqual([2000, 0]);
  });
});

describe('several things in the list', () => {
  it('have their common fields above, told where they differ, and changed in all by one step', async () => {
    const thick = { ...samples.wall, id: 'thick', thickness: 30 };
    const { editor, object, steps } = await list([samples.wall, thick, samples.block]);
    expect(document.querySelector('[data-testid="together"]')).toBeNull();
    editor.select({ ids: ['wall', 'thick'], robot: false });
    await nextTick();
    const together = document.querySelector<HTMLElement>('[data-testid="together"]')!;
    expect(textOf(together.querySelector('h3'))).toBe('Alle 2 zusammen');
    const thickness = together.querySelector('input')!;
    expect([thickness.value, thickness.placeholder]).toEqual(['', 'verschieden']);
    thickness.value = '2';
    thickness.dispatchEvent(new Event('input', { bubbles: true }));
    thickness.dispatchEvent(new Event('change', { bubbles: true }));
    await nextTick();
    expect([object('wall', 'wall').thickness, object('wall', 'thick').thickness, steps()]).toEqual([20, 20, 1]);
  });
});

describe('the picture on the floor', () => {
  const background = { at: [100, 100], size: [400, 200], cells: [1, 1], levels: 'AA==', picture: '' } as const;
  const settings = async (has = true) => {
    const page = await editingPage([], has ? { background } : {});
    return { ...page, mounted: mountOn(page, BackgroundSettings), floor: () => page.scene().background };
  };
  afterEach(() => void vi.restoreAllMocks());

  it('has nothing to set before there is one', async () => {
    const { mounted } = await settings(false);
    expect(mounted.findAll('button').map((it) => it.text())).toEqual(['Bild wählen …']);
    expect(mounted.findAll('input')).toHaveLength(0);
  });

  it('keeps its shape when one side changes', async () => {
    const { floor } = await settings();
    await fill('Breite', '80');
    expect(floor()?.size).toEqual([800, 400]);
    await fill('Höhe', '10');
    expect(floor()?.size).toEqual([200, 100]);
  });

  it('changes one side alone where the shape need not be kept', async () => {
    const { floor, mounted } = await settings();
    await mounted.get('input[type="checkbox"]').setValue(false);
    await fill('Breite', '80');
    expect(floor()?.size).toEqual([800, 200]);
  });

  it('is never narrower than 1 cm', async () => {
    const { floor } = await settings();
    await fill('Breite', '1');
    expect(floor()?.size).toEqual([10, 10]);
  });

  it('is placed from the left and from below', async () => {
    const { floor } = await settings();
    await fill('Von links', '-5');
    await fill('Von unten', '30');
    expect(floor()?.at).toEqual([-50, 300]);
  });

  it('fills the arena as far as its shape allows, in the middle, as one step', async () => {
    const { floor, steps, editor } = await settings();
    await press('Auf die Arena einpassen');
    expect(floor()).toMatchObject({ size: [1200, 600], at: [0, 150] });
    expect(steps()).toBe(1);
    editor.undo();
    expect(floor()).toEqual(background);
  });

  it('can be taken away and brought back', async () => {
    const { floor, editor, mounted } = await settings();
    await press('Bild entfernen');
    expect([floor(), mounted.findAll('button').length]).toEqual([null, 1]);
    editor.undo();
    expect(floor()).toEqual(background);
  });

  /** Picks this file, as in the browser's file dialog. */
  function offering(file: File): void {
    vi.spyOn(HTMLInputElement.prototype, 'click').mockImplementation(function (this: HTMLInputElement) {
      Object.defineProperty(this, 'files', { value: [file] });
      this.dispatchEvent(new Event('change'));
    });
  }

  it.each([
    ['no picture', 'Das ist kein Bild', new File(['print(1)'], 'main.py')],
    ['an SVG with a program in it', 'Diese SVG-Datei enthält mehr', new File(['<svg xmlns="http://www.w3.org/2000/svg"><script>alert(1)</script></svg>'], 'a.svg', { type: 'image/svg+xml' })], // prettier-ignore
    ['more than 50 MB', 'Die Datei ist grösser als 50 MB', new File([new Uint8Array(50_000_001)], 'a.png')],
    ['no picture, which is only seen in a file that is no larger', 'Das ist kein Bild', new File([new Uint8Array(50_000_000)], 'a.png')], // prettier-ignore
  ])('refuses %s, says why and leaves the course alone', async (_, why, file) => {
    offering(file);
    const { mounted, steps } = await settings(false);
    await press('Bild wählen …');
    await vi.waitFor(() => expect(mounted.find('[role="alert"]').text()).toContain(why));
    expect(steps()).toBe(0);
    expect((named('Bild wählen …') as HTMLButtonElement).disabled).toBe(false);
  });
});
