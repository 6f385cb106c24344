// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { defineComponent, h } from 'vue';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { createPage } from '../../../app/testing/page';
import { mountOn } from '../../../app/testing/mount-on';
import { joinEditor } from '../join-editor';
import { useCourseEditor } from '../state/parts';
import CardPicture from './CardPicture.vue';

const PICTURE = 'data:image/png;base64,AA==';
let finish = (): void => undefined;
vi.mock('../background/read-image', () => ({
  readPicture: () => new Promise((done) => (finish = () => done({ picture: PICTURE }))),
}));
vi.mock('../../../kit/files/pick-files', () => ({
  PICTURES: '',
  pickFiles: (_wish: unknown, take: (files: readonly File[]) => void) => take([new File([], 'a.png')]),
}));

beforeEach(() => sessionStorage.clear());
afterEach(() => document.body.replaceChildren());

function chosen() {
  const page = createPage();
  const Joined = defineComponent({
    setup() {
      joinEditor(useCourseEditor().editor);
      return () => h(CardPicture);
    },
  });
  mountOn(page, Joined);
  document.querySelector<HTMLElement>('[data-testid=card-picture]')!.click();
  return page;
}
const pictureOf = ({ work }: ReturnType<typeof createPage>) => work.scene.value.task.card?.picture ?? '';

describe('the picture of a card', () => {
  it('is there once it is read', async () => {
    const page = chosen();
    await flushPromises();
    finish();
    await flushPromises();
    expect(pictureOf(page)).toBe(PICTURE);
  });

  it('does not land on another course that was opened while it was read', async () => {
    const page = chosen();
    await flushPromises();
    const { project } = page.work.work.value;
    page.work.openProject({ ...project, scene: { ...project.scene, name: 'Anders' } }, null);
    finish();
    await flushPromises();
    expect(pictureOf(page)).toBe('');
  });
});
