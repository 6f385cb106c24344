import { describeEdit, type EditDescription } from '#editor/describe-edit';
import type { Selection } from '#editor/tools/tool';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';

import type { Happened } from '../state/course-editor-model';
import { t } from '../../../kit/i18n';
import toolWords from '../../../kit/words/tools';
import { cm, countText, namesOf, placeText, whereText } from './object-words';
import editingWords from './editing';
import kindNames from './kinds';

const texts = editingWords.happened;

/** An event of the editor as a sentence for screen readers. */
export function wordsFor(happened: Happened): string {
  switch (happened.type) {
    case 'edit':
      return editWords(happened);
    // Name what had been done, not its reverse.
    case 'undo':
      return t(texts.undone, { what: editWords(happened) });
    case 'redo':
      return t(texts.redone, { what: editWords(happened) });
    case 'problem':
      return t('notice.courseFull');
    case 'selected':
      return selectionWords(happened.scene, happened.selection);
    case 'copied':
      return t(texts.copied);
    case 'tool':
      return t(toolWords[happened.tool].about);
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
      return t(texts[it.type]);
    case 'course':
      return t(texts.course);
    case 'drew':
    case 'erased':
      return t(texts[it.type], { cm: cm(it.lengthMm) });
    case 'added':
      return it.at === null
        ? t(texts.added, { what: countText(it.kind, it.count) })
        : t(texts.addedAt, { what: countText(it.kind, it.count), at: placeText(it.at) });
    case 'removed':
    case 'changed':
    case 'locked':
    case 'unlocked':
    case 'grouped':
    case 'ungrouped':
      return t(texts[it.type], { what: countText(it.kind, it.count) });
    case 'moved':
      return it.at === null
        ? t(texts.moved, { what: countText(it.kind, it.count) })
        : t(texts.movedTo, { what: countText(it.kind, it.count), at: placeText(it.at) });
    case 'turned':
      return it.byDeg === null
        ? t(texts.turned, { what: countText(it.kind, it.count) })
        : t(texts.turnedBy, { what: countText(it.kind, it.count), deg: it.byDeg });
    case 'sized':
      return t(texts.sized, { what: t(kindNames[it.kind].one), x: cm(it.size[0]), y: cm(it.size[1]) });
    case 'robot':
      return robotWords(it);
    default:
      return it satisfies never;
  }
}

function robotWords({ at, headingDeg, scale }: Extract<EditDescription, { type: 'robot' }>): string {
  const parts = [
    at === null ? '' : t(texts.startAt, { at: placeText(at) }),
    headingDeg === null ? '' : t(texts.startHeading, { deg: headingDeg }),
    scale === null ? '' : t(texts.startScale, { scale }),
  ].filter((part) => part !== '');
  return parts.length === 0 ? t(texts.start) : parts.join(', ');
}

function selectionWords(scene: Scene, { ids, robot }: Selection): string {
  const count = ids.length + (robot ? 1 : 0);
  if (count === 0) return t(texts.deselected);
  if (count > 1) return t(texts.selectedMany, { count });
  if (robot) return t(texts.selected, { what: t(texts.robotStart, { at: placeText(scene.robot.at) }) });
  const object = scene.objects.find(({ id }) => id === ids[0]);
  if (object === undefined) return t(texts.deselected);
  const what = [
    namesOf(scene).get(object.id),
    whereText(object),
    ...(object.lock ? [t(editingWords.list.locked)] : []),
  ];
  return t(texts.selected, { what: what.join(', ') });
}
