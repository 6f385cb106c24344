import type { Scene } from '#scene/scene';

/** Whether a course asks for something, or has something that must not be touched: then the verdict bar belongs to it. */
export function hasTask({ task, objects }: Pick<Scene, 'task' | 'objects'>): boolean {
  if (task.noTouch || task.seconds !== null) return true;
  return objects.some((object) => {
    switch (object.type) {
      case 'target':
      case 'checkpoint':
      case 'forbidden':
      case 'spikes':
        return true;
      case 'mover':
        return object.spiked;
      case 'wall':
      case 'block':
      case 'fixed-block':
      case 'stroke':
      case 'label':
        return false;
      default:
        return object satisfies never;
    }
  });
}
