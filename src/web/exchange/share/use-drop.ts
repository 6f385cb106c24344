import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';

/** Elements that take dropped files themselves. */
const TAKERS = '[data-takes-files]';

/** Takes files that are dropped onto the page. Returns whether files are being held over it. */
export function useDrop(take: (files: Iterable<File>) => void): Readonly<ShallowRef<boolean>> {
  const isOver = shallowRef(false);
  const hasFiles = ({ dataTransfer, target }: DragEvent): boolean =>
    dataTransfer?.types.includes('Files') === true && !(target instanceof Element && target.closest(TAKERS));
  function over(event: DragEvent): void {
    if (!hasFiles(event)) return;
    event.preventDefault();
    isOver.value = true;
  }
  function leave(event: DragEvent): void {
    if (event.relatedTarget === null) isOver.value = false;
  }
  function drop(event: DragEvent): void {
    isOver.value = false;
    if (!hasFiles(event)) return;
    event.preventDefault();
    event.stopPropagation();
    take(event.dataTransfer?.files ?? []);
  }
  // In the capture phase: the code editor would type a dropped file's text instead.
  const options = { capture: true };
  addEventListener('dragover', over, options);
  addEventListener('dragleave', leave, options);
  addEventListener('drop', drop, options);
  onScopeDispose(() => {
    removeEventListener('dragover', over, options);
    removeEventListener('dragleave', leave, options);
    removeEventListener('drop', drop, options);
  });
  return isOver;
}
