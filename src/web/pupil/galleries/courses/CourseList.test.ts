// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';

import { byId, isThere, tap } from '../../../app/testing/find';
import { mountOn } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import CourseList from './CourseList.vue';

const titles = (): readonly (string | undefined)[] =>
  [...document.querySelectorAll('[role="menuitem"] .page-list-item-title')].map((it) => it.textContent?.trim());

describe('the menu of the task', () => {
  it('has the present task, the works, the missions, the gallery, an empty arena and the samples: at most eight entries', () => {
    mountOn(createPage(), CourseList);
    expect(titles()).toEqual([
      ...['Eine Sekunde vorwärts', 'Startprogramm zurückholen'],
      ...['Meine Arbeiten', 'Alle Missionen', 'Parcours-Galerie', 'Leere Arena', 'Beispielprogramme'],
    ]);
  });

  it('has the latest works below the task, and opens an empty arena', async () => {
    const page = createPage();
    page.work.setText('main.py', 'mine = 1\n');
    page.work.openProject({ ...page.work.work.value.project, files: [{ name: 'main.py', text: '' }] }, 'Meins');
    mountOn(page, CourseList);
    expect(byId('previous').textContent).toContain('Meins');
    await tap('empty-arena');
    expect([page.work.work.value.project.course, page.mode.current.value]).toEqual(['empty', 'build']);
  });

  it('unfolds the samples, of which one robot’s at a time', async () => {
    mountOn(createPage(), CourseList);
    expect(isThere('examples-maqueen-lite')).toBe(false);
    await tap('samples');
    expect(byId('examples-maqueen-lite').getAttribute('aria-expanded')).toBe('false');
    await tap('examples-maqueen-lite');
    expect(document.querySelectorAll('[data-testid^="example-maqueen-lite"]').length).toBeGreaterThan(1);
    await tap('programs');
    expect(document.querySelector('[data-testid^="example-maqueen-lite"]')).toBeNull();
  });

  it('leads to the pages of works, missions and courses', async () => {
    const page = createPage();
    const left = vi.fn((open: () => void) => open());
    mountOn(page, CourseList, { onLeave: left });
    for (const [id, name] of [
      ['my-works', 'works'],
      ['missions', 'missions'],
      ['all-courses', 'courses'],
    ] as const) {
      // prettier-ignore
      await tap(id);
      expect(page.router.page.value?.name).toBe(name);
    }
    history.replaceState(null, '', '/');
  });
});
