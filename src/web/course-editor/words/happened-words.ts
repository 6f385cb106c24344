import { describeEdit, type EditDescription } from '#editor/describe-edit';
import type { Selection } from '#editor/tools/tool';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';

import type { Happened } from '../state/course-editor-model';
import { t } from '../../page/i18n';
import { say } from '../../page/i18n/say';
import { cm, countText, namesOf, placeText, whereText } from './object-words';
import editingWords from './editing';
import kindNames from './kinds';

const texts = editingWords.happened;

/** What happened in the editor as a sentence for screen readers. */
export function wordsFor(happened: Happened): string {
  switch (happened.type) {
    case 'edit':
      return editWords(happened);
    // Name what had been done, not its reverse.
    case 'undo':
      return say(texts.undone, { what: editWords(happened) });
    case 'redo':
      return say(texts.redone, { what: editWords(happened) });
    case 'problem':
      return say(editingWords.panels.tooMuch);
    case 'selected':
      return selectionWords(happened.scene, happened.selection);
    case 'copied':
      return say(texts.copied);
    case 'tool':
      return t(`tool.${happened.tool}.about`);
    default:
      return happened satisfies never;
  }
}

const editWords = ({ scene, edit }: { readonly scene: Scene; readonly edit: SceneEdit }): string =>
  descriptionWords(describeEdit(scene, edit));

function descriptionWords(it: EditDescription): string {
  switch (it.type) {
    case 'nothing':
    case 'several':
    case 'cleared':
      return say(texts[it.type]);
    case 'course':
      return say(texts.course);
    case 'drew':
    case 'erased':
      return say(texts[it.type], { cm: cm(it.lengthMm) });
    case 'added':
      return it.at === null
        ? say(texts.added, { what: countText(it.kind, it.count) })
        : say(texts.addedAt, { what: countText(it.kind, it.count), at: placeText(it.at) });
    case 'removed':
    case 'changed':
    case 'locked':
    case 'unlocked':
    case 'grouped':
    case 'ungrouped':
      return say(texts[it.type], { what: countText(it.kind, it.count) });
    case 'moved':
      return it.at === null
        ? say(texts.moved, { what: countText(it.kind, it.count) })
        : say(texts.movedTo, { what: countText(it.kind, it.count), at: placeText(it.at) });
    case 'turned':
      return it.byDeg === null
        ? say(texts.turned, { what: countText(it.kind, it.count) })
        : say(texts.turnedBy, { what: countText(it.kind, it.count), deg: it.byDeg });
    case 'sized':
      return say(texts.sized, { what: say(kindNames[it.kind].one), x: cm(it.size[0]), y: cm(it.size[1]) });
    case 'robot':
      return robotWords(it);
    default:
      return it satisfies never;
  }
}

function robotWords({ at, headingDeg, scale }: Extract<EditDescription, { type: 'robot' }>): string {
  const parts = [
    at === null ? '' : say(texts.startAt, { at: placeText(at) }),
    headingDeg === null ? '' : say(texts.startHeading, { deg: headingDeg }),
    scale === null ? '' : say(texts.startScale, { scale }),
  ].filter((part) => part !== '');
  return parts.length === 0 ? say(texts.start) : parts.join(', ');
}

function selectionWords(scene: Scene, { ids, robot }: Selection): string {
  const count = ids.length + (robot ? 1 : 0);
  if (count === 0) return say(texts.deselected);
  if (count > 1) return say(texts.selectedMany, { count });
  if (robot) return say(texts.selected, { what: say(texts.robotStart, { at: placeText(scene.robot.at) }) });
  const object = scene.objects.find(({ id }) => id === ids[0]);
  if (object === undefined) return say(texts.deselected);
  const what = [
    namesOf(scene).get(object.id),
    whereText(object),
    ...(object.lock ? [say(editingWords.list.locked)] : []),
  ];
  return say(texts.selected, { what: what.join(', ') });
}
