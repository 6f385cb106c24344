// @vitest-environment happy-dom
import { defineComponent, h, nextTick } from 'vue';
import { beforeEach, describe, expect, it, vi } from 'vitest';

import { sceneDefaults } from '#scene/scene';
import { createPage } from '../../../app/testing/page';
import { mountOn } from '../../../app/testing/mount-on';
import { loadTexts, showLanguage } from '../../../kit/i18n';
import { nameToSave } from '../../../session/work/work-name';
import CardInPlace from './CardInPlace.vue';

/** A page with the card of its course. */
function cardPage() {
  const page = createPage();
  mountOn(page, defineComponent({ setup: () => () => h(CardInPlace, { checks: [] }) }));
  const field = document.querySelector<HTMLInputElement>('[data-testid=maker-title]')!;
  async function entitle(title: string): Promise<void> {
    field.value = title;
    field.dispatchEvent(new Event('input'));
    field.dispatchEvent(new Event('change'));
    await nextTick();
  }
  return { ...page, entitle };
}

beforeEach(() => {
  document.body.innerHTML = '';
  sessionStorage.clear();
});

describe('the title of a card', () => {
  it('names a ready course that it is written over, so that files are called by it, and keeps its text', async () => {
    const { entitle, work } = cardPage();
    expect(work.work.value.project.course).not.toBeNull();
    const told = document.querySelector('[data-testid=maker-text]')!.textContent;
    await entitle('Ab in die Garage');
    expect([work.work.value.project.course, work.scene.value.name]).toEqual([null, 'Ab in die Garage']);
    expect(nameToSave({ work })).toBe('Ab in die Garage');
    expect(document.querySelector('[data-testid=maker-text]')!.textContent).toBe(told);
  });
});

describe('the text of a card', () => {
  const box = () => document.querySelector<HTMLTextAreaElement>('textarea[data-testid=maker-text]');

  it('of the empty arena is none once the course has a name', async () => {
    const { entitle, work } = cardPage();
    work.openProject({ ...work.work.value.project, course: 'empty' }, null);
    await entitle('Ab in die Garage');
    expect(work.scene.value.description).toBe('');
  });

  it('stays a box as long as something else is pressed, which would move away under the pointer, and is kept', async () => {
    vi.useFakeTimers({ toFake: ['setTimeout'] });
    const { work } = cardPage();
    document.querySelector<HTMLElement>('[data-testid=maker-text]')!.click();
    await nextTick();
    await nextTick();
    box()!.value = 'Fahr los.';
    box()!.dispatchEvent(new Event('input'));
    document.body.dispatchEvent(new Event('pointerdown', { bubbles: true }));
    box()!.blur();
    await nextTick();
    expect(work.scene.value.description).toBe('Fahr los.');
    expect(box()).not.toBeNull();
    document.body.dispatchEvent(new Event('pointerup', { bubbles: true }));
    vi.runAllTimers();
    await nextTick();
    expect(box()).toBeNull();
    vi.useRealTimers();
  });

  const type = async (text: string): Promise<void> => {
    document.querySelector<HTMLElement>('[data-testid=maker-text]')!.click();
    await nextTick();
    await nextTick();
    box()!.value = text;
    box()!.dispatchEvent(new Event('input'));
  };
  const point = (type: string): boolean => document.body.dispatchEvent(new Event(type, { bubbles: true }));

  it('is not written into the language that is pressed while it is a box', async () => {
    const { work } = cardPage();
    document.querySelector<HTMLElement>('[data-testid=maker-more-languages]')!.click();
    await nextTick();
    vi.useFakeTimers({ toFake: ['setTimeout'] });
    await type('Fahr los.');
    point('pointerdown');
    box()!.blur();
    point('pointerup');
    document.querySelector<HTMLElement>('[data-testid=card-language-fr]')!.click();
    await nextTick();
    vi.runAllTimers();
    await nextTick();
    vi.useRealTimers();
    expect(work.scene.value.description).toBe('Fahr los.');
    expect(work.scene.value.task.card?.translations ?? []).toEqual([]);
    expect(document.querySelector('[data-testid=maker-text]')!.textContent).not.toContain('Fahr los.');
  });

  it('closes when the pointer comes back that was let go outside of the window, and is not kept again', async () => {
    vi.useFakeTimers({ toFake: ['setTimeout'] });
    const { work } = cardPage();
    await type('Fahr los.');
    point('pointerdown');
    box()!.blur();
    work.edit({ type: 'course', changes: { description: 'Halt an.' } });
    document.body.dispatchEvent(Object.assign(new Event('pointermove', { bubbles: true }), { buttons: 0 }));
    vi.runAllTimers();
    await nextTick();
    vi.useRealTimers();
    expect(box()).toBeNull();
    expect(work.scene.value.description).toBe('Halt an.');
  });

  it('of a teacher is not selected as a whole in a translation, as that of a ready course is', async () => {
    cardPage();
    document.querySelector<HTMLElement>('[data-testid=maker-text]')!.click();
    await nextTick();
    await nextTick();
    expect(box()!.selectionEnd).toBeGreaterThan(box()!.selectionStart);
    box()!.blur();
    await nextTick();
    document.querySelector<HTMLElement>('[data-testid=maker-more-languages]')!.click();
    await nextTick();
    document.querySelector<HTMLElement>('[data-testid=card-language-fr]')!.click();
    await nextTick();
    await type('Roule.');
    box()!.blur();
    await nextTick();
    document.querySelector<HTMLElement>('[data-testid=maker-text]')!.click();
    await nextTick();
    await nextTick();
    expect(box()!.value).toBe('Roule.');
    expect(box()!.selectionEnd).toBe(box()!.selectionStart);
  });
});

describe('a card in several languages', () => {
  const press = async (id: string): Promise<void> => {
    document.querySelector<HTMLElement>(`[data-testid=${id}]`)!.click();
    await nextTick();
  };

  it('is written in a second one, and the course keeps its name', async () => {
    const { entitle, work } = cardPage();
    await entitle('Ab in die Garage');
    await press('maker-more-languages');
    await press('card-language-fr');
    expect(document.querySelector<HTMLInputElement>('[data-testid=maker-title]')!.value).toBe('');
    await entitle('Au garage');
    expect(work.scene.value.name).toBe('Ab in die Garage');
    expect(work.scene.value.task.card?.translations).toMatchObject([{ language: 'fr', title: 'Au garage' }]);
    await press('card-language-en');
    await press('card-language-fr');
    expect(document.querySelector<HTMLInputElement>('[data-testid=maker-title]')!.value).toBe('Au garage');
    await entitle('');
    expect(work.scene.value.task.card?.translations ?? []).toEqual([]);
  });

  it('has the keyboard at the language that is pressed once it has languages', async () => {
    await loadTexts('fr');
    showLanguage('fr');
    cardPage();
    await press('maker-more-languages');
    await nextTick();
    expect(document.activeElement?.getAttribute('data-testid')).toBe('card-language-fr');
    expect(document.activeElement?.getAttribute('aria-pressed')).toBe('true');
  });

  it('has the keyboard at its own language once it has languages, and at the picture once that is removed', async () => {
    const { work } = cardPage();
    await press('maker-more-languages');
    await nextTick();
    expect(document.activeElement?.getAttribute('data-testid')).toBe('card-language-de');
    work.edit({ type: 'course', changes: { task: { ...work.scene.value.task, card: { ...sceneDefaults.card, picture: 'data:image/png;base64,AA==' } } } }); // prettier-ignore
    await nextTick();
    await press('card-picture-remove');
    expect(document.activeElement?.getAttribute('data-testid')).toBe('card-picture');
  });

  it('has a picture that can be removed', async () => {
    const { work } = cardPage();
    expect(document.querySelector('[data-testid=card-picture-remove]')).toBeNull();
    const { task } = work.scene.value;
    work.edit({ type: 'course', changes: { task: { ...task, card: { ...sceneDefaults.card, picture: 'data:image/png;base64,AA==' } } } }); // prettier-ignore
    await nextTick();
    await press('card-picture-remove');
    expect(work.scene.value.task.card?.picture ?? '').toBe('');
  });
});
