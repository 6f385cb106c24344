// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { readyGroups, readyPart } from '#editor/parts/ready-parts';

import { editingPage, fill, keyOn, press, samples } from '../../../app/testing/editing';
import { mountOn, named, textOf } from '../../../app/testing/mount-on';
import { PARTS_KEY } from './own-parts';
import PartsShelf from './PartsShelf.vue';

const shelf = () => document.querySelector<HTMLElement>('[data-testid="parts-shelf"]')!;
const card = (id: string) => document.querySelector<HTMLElement>(`[data-testid="part-${id}"]`);

async function opened(...given: Parameters<typeof editingPage>) {
  const page = await editingPage(...given);
  const close = vi.fn();
  mountOn(page, PartsShelf, { onClose: close });
  await nextTick();
  return { ...page, close };
}

/** Chooses an entry of a part's menu. */
async function fromMenu(part: string, entry: string): Promise<void> {
  await press(`${part}: mehr`);
  document.querySelector<HTMLElement>(`[data-testid="part-${entry}"]`)!.click();
  await nextTick();
  await nextTick();
}

describe('the shelf of parts', () => {
  it('has all ready parts, with their names and their true sizes', async () => {
    await opened();
    const all = Object.values(readyGroups).flat();
    expect(all.map((name) => card(name)?.getAttribute('aria-label')?.includes('einsetzen'))).toEqual(all.map(() => true)); // prettier-ignore
    expect(named('Kurve 15 × 15 cm, einsetzen').textContent).toContain('15 × 15 cm');
  });

  it('inserts a part by a tap: in the middle, selected, as one step', async () => {
    const { scene, editor, steps } = await opened([], { robot: { ...(await editingPage()).scene().robot, at: [100, 100] } }); // prettier-ignore
    card('straight')!.click();
    await nextTick();
    expect(scene().objects).toMatchObject([{ type: 'stroke', points: [[530, 450], [680, 450]] }]); // prettier-ignore
    expect([editor.selection.value.ids, steps(), editor.tool.value]).toEqual([['stroke-1'], 1, 'select']);
  });

  it('inserts in the middle of what is seen of the arena, and beside what stands there', async () => {
    const { scene, editor } = await opened();
    editor.view.value = { show: () => undefined, at: () => null, middle: () => ({ x: 300, y: 200 }), reachMm: () => 8 };
    card('gate')!.click();
    card('gate')!.click();
    await nextTick();
    expect(scene().objects.map((object) => 'at' in object && object.at)).toEqual([[190, 200], [410, 200], [190, 150], [410, 150]]); // prettier-ignore
  });

  it('says Start on the start box in the language of the page', async () => {
    const { scene } = await opened();
    card('start-box')!.click();
    await nextTick();
    expect(scene().objects).toContainEqual(expect.objectContaining({ type: 'label', text: 'Start' }));
  });

  it('brings a part onto the course by a drag, with the end of its line onto the end of a line; Escape drops it', async () => {
    const line = { type: 'stroke', id: 's', points: [[103, 407], [223, 407]], width: 20, color: 'black' } as const; // prettier-ignore
    const { scene, editor, steps } = await opened([line]);
    editor.view.value = { show: () => undefined, at: (x, y) => (x < 500 ? null : { x: x - 500, y }), middle: () => ({ x: 0, y: 0 }), reachMm: () => 8 }; // prettier-ignore
    const point = (type: string, x: number, y: number, at: EventTarget = window) =>
      at.dispatchEvent(new PointerEvent(type, { pointerId: 1, button: 0, clientX: x, clientY: y, bubbles: true }));
    point('pointerdown', 40, 400, card('straight')!);
    point('pointermove', 100, 405);
    await nextTick();
    expect(document.querySelector('.carried')).not.toBeNull();
    point('pointermove', 801, 409);
    await nextTick();
    expect([document.querySelector('.carried'), editor.brought.value?.type]).toEqual([null, 'add']);
    await keyOn(window, 'Escape');
    point('pointerup', 801, 409);
    expect([editor.brought.value, steps()]).toEqual([null, 0]);

    point('pointerdown', 40, 400, card('straight')!);
    point('pointermove', 801, 409);
    point('pointerup', 801, 409);
    expect(scene().objects[1]).toMatchObject({ points: [[223, 407], [373, 407]] }); // prettier-ignore
    expect([steps(), editor.brought.value, editor.selection.value.ids]).toEqual([1, null, ['stroke-1']]);
  });

  it('keeps what is selected under a name, to be there when it is opened again', async () => {
    const first = await opened([samples.wall, samples.block]);
    expect(named('Auswahl als Teil ablegen').hasAttribute('disabled')).toBe(true);
    first.editor.select({ ids: ['wall', 'block'], robot: false });
    await nextTick();
    await press('Auswahl als Teil ablegen');
    await fill('Name des Teils', ' Hindernis ');
    await press('Ablegen');
    await vi.waitFor(() => expect(document.activeElement).toBe(card('own-1')));
    expect(textOf(card('own-1'))).toContain('Hindernis');
    document.body.innerHTML = '<section id="menus"></section>';
    const again = await opened();
    card('own-1')!.click();
    await nextTick();
    expect(again.scene().objects.map(({ type }) => type)).toEqual(['wall', 'block']);
  });

  it('asks for the name at once when the menu of the selection opens it, and has one where none is typed', async () => {
    const page = await editingPage([samples.wall]);
    page.editor.choose('select');
    page.editor.select({ ids: ['wall'], robot: false });
    page.panels.keeps.value = true;
    mountOn(page, PartsShelf);
    await nextTick();
    await press('Ablegen');
    await vi.waitFor(() => expect(textOf(card('own-1'))).toContain('Teil 1'));
    expect(page.panels.keeps.value).toBe(false);
  });

  it('gives one’s own another name, and takes it off the shelf, which can be undone', async () => {
    const clip: unknown = { format: 'parcours-objects', course: { format: 'parcours-scene', version: 2, objects: [samples.wall] } }; // prettier-ignore
    localStorage.setItem(PARTS_KEY, JSON.stringify({ version: 1, parts: [{ id: 'own-1', name: 'Mauer', clip }] }));
    const { notices } = await opened();
    await fromMenu('Mauer', 'rename');
    await fill('Name des Teils', 'Wand');
    await press('Umbenennen', 'button');
    await vi.waitFor(() => expect(textOf(card('own-1'))).toContain('Wand'));
    await fromMenu('Wand', 'remove');
    expect([card('own-1'), notices.current.value?.values]).toEqual([null, { text: '«Wand» ist nicht mehr auf dem Regal.' }]); // prettier-ignore
    notices.current.value!.action!.run();
    await nextTick();
    expect(textOf(card('own-1'))).toContain('Wand');
  });

  it('says what it could not read, and keeps working', async () => {
    localStorage.setItem(PARTS_KEY, '{"parts": [1');
    await opened([samples.wall]);
    expect(textOf(document.querySelector('[data-testid="parts-unread"]'))).toContain('nicht lesen lassen: 1');
    expect(card('straight')).not.toBeNull();
  });

  it('prints a part alone: the print room gets it as a course with its name, and closing it leads back', async () => {
    const { panels } = await opened();
    await fromMenu('Kurve', 'print');
    expect(panels.shown.value).toBe('print');
    expect(panels.printed.value).toMatchObject({ name: 'Kurve', size: [180, 180] });
    expect(panels.printed.value?.objects).toHaveLength(readyPart('curve').objects.length);
    panels.close();
    expect([panels.shown.value, panels.printed.value]).toEqual(['parts', null]);
  });

  it('is closed by Escape, which first only ends the name', async () => {
    const { close, editor } = await opened([samples.wall]);
    editor.select({ ids: ['wall'], robot: false });
    await nextTick();
    await press('Auswahl als Teil ablegen');
    await keyOn(named('Name des Teils', 'input'), 'Escape');
    expect(close).not.toHaveBeenCalled();
    await keyOn(shelf(), 'Escape');
    expect(close).toHaveBeenCalledOnce();
  });
});
