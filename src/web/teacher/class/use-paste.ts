import { onBeforeUnmount, onMounted, shallowRef, type Ref } from 'vue';

import { listSources } from '#intake/sources';

import { chosenFiles } from '../../kit/files/added-files';
import { t } from '../../kit/i18n';
import { readyScene } from '../../session/work/catalogue/ready-courses';
import type { ClassModel } from './model/class-model';
import words from './words';
import { takeFiles } from './take-files';
import { offerLink } from './task-series';

/**
 * Time for which the message on a paste is shown, in ms. Chosen: read twice; nothing old should stay on a projector.
 */
const SAID_MS = 8000;

/**
 * Takes hand-ins that are pasted anywhere on the page: links with whatever stands around them, also behind words of a
 * formatted text, or files. What is pasted into a field is left to the field.
 *
 * @returns the message about the last paste; empty after a while
 */
export function usePaste(model: ClassModel): Readonly<Ref<string>> {
  const said = shallowRef('');
  let timer: ReturnType<typeof setTimeout> | undefined;
  const tell = (text: string): void => {
    said.value = text;
    clearTimeout(timer);
    timer = setTimeout(() => (said.value = ''), SAID_MS);
  };

  async function take(event: ClipboardEvent): Promise<void> {
    const { clipboardData, target } = event;
    const isField = target instanceof Element && target.closest('input, textarea, select, [contenteditable]') !== null;
    if (isField || clipboardData === null) return;
    event.preventDefault();
    event.stopPropagation();
    // All of it must be read before anything is waited for.
    const [text, page] = ['text/plain', 'text/html'].map((type) => clipboardData.getData(type));
    const files = chosenFiles(clipboardData.files);
    if (files.length > 0) {
      const count = await takeFiles(model, files);
      if (count > 0) tell(t(words.pasted, { count }));
      return;
    }
    const hasSeries = offerLink(model, text ?? '') || offerLink(model, page ?? '');
    const inText = listSources(text ?? '', readyScene);
    const links = inText.length > 0 ? inText : listSources(page ?? '', readyScene, 'pasted.html');
    if (links.length > 0) tell(t(words.pasted, { count: links.length }));
    else if (!hasSeries) tell(t(words.noLinks));
    if (links.length > 0) await model.add(links);
  }
  const listener = (event: ClipboardEvent): void => void take(event);

  onMounted(() => document.addEventListener('paste', listener));
  onBeforeUnmount(() => {
    clearTimeout(timer);
    document.removeEventListener('paste', listener);
  });
  return said;
}
