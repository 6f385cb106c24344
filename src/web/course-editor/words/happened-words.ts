import type { Texts } from '#core/texts';
import { describeChange, type EditDescription } from '#editor/describe-edit';
import type { Selection } from '#editor/tools/tool';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';

import type { Happened } from '../state/course-editor-model';
import { say } from '../../page/i18n/say';
import { cm, countText, kindTexts, namesOf, placeText, whereText } from './object-words';
import { toolTexts } from './palette-texts';
import { panelTexts } from './panel-texts';

const texts = {
  undone: { de: 'Rückgängig: {what}', fr: 'Annulé : {what}', it: 'Annullato: {what}', en: 'Undone: {what}' },
  redone: { de: 'Wiederholt: {what}', fr: 'Rétabli : {what}', it: 'Ripetuto: {what}', en: 'Done again: {what}' },
  drew: {
    de: 'Linie gezeichnet, {cm} cm',
    fr: 'Ligne dessinée, {cm} cm',
    it: 'Linea disegnata, {cm} cm',
    en: 'Line drawn, {cm} cm',
  },
  added: { de: '{what} hinzugefügt', fr: 'Ajouté : {what}', it: 'Aggiunto: {what}', en: '{what} added' },
  addedAt: {
    de: '{what} hinzugefügt bei {at} cm',
    fr: 'Ajouté : {what}, à {at} cm',
    it: 'Aggiunto: {what}, a {at} cm',
    en: '{what} added at {at} cm',
  },
  removed: { de: '{what} gelöscht', fr: 'Supprimé : {what}', it: 'Eliminato: {what}', en: '{what} deleted' },
  cleared: { de: 'Alles gelöscht', fr: 'Tout est effacé', it: 'Cancellato tutto', en: 'Everything cleared' },
  erased: {
    de: 'Linie radiert, {cm} cm',
    fr: 'Ligne gommée, {cm} cm',
    it: 'Linea cancellata, {cm} cm',
    en: 'Line erased, {cm} cm',
  },
  movedTo: {
    de: '{what} verschoben nach {at} cm',
    fr: 'Déplacé : {what}, à {at} cm',
    it: 'Spostato: {what}, a {at} cm',
    en: '{what} moved to {at} cm',
  },
  moved: { de: '{what} verschoben', fr: 'Déplacé : {what}', it: 'Spostato: {what}', en: '{what} moved' },
  turnedBy: {
    de: '{what} um {deg} Grad gedreht',
    fr: 'Tourné de {deg} degrés : {what}',
    it: 'Ruotato di {deg} gradi: {what}',
    en: '{what} turned by {deg} degrees',
  },
  turned: { de: '{what} gedreht', fr: 'Tourné : {what}', it: 'Ruotato: {what}', en: '{what} turned' },
  sized: {
    de: '{what} ist jetzt {x} mal {y} cm gross',
    fr: '{what} : maintenant {x} sur {y} cm',
    it: '{what}: ora {x} per {y} cm',
    en: '{what} is now {x} by {y} cm',
  },
  changed: { de: '{what} geändert', fr: 'Modifié : {what}', it: 'Modificato: {what}', en: '{what} changed' },
  startAt: { de: 'Start bei {at} cm', fr: 'Départ à {at} cm', it: 'Partenza a {at} cm', en: 'Start at {at} cm' },
  startHeading: {
    de: 'Richtung {deg} Grad',
    fr: 'direction {deg} degrés',
    it: 'direzione {deg} gradi',
    en: 'heading {deg} degrees',
  },
  startScale: {
    de: 'Roboter {scale} mal so gross',
    fr: 'robot {scale} fois sa taille',
    it: 'robot {scale} volte la sua grandezza',
    en: 'robot {scale} times its size',
  },
  start: { de: 'Start geändert', fr: 'Départ modifié', it: 'Partenza modificata', en: 'Start changed' },
  course: { de: 'Strecke geändert', fr: 'Parcours modifié', it: 'Percorso modificato', en: 'Course changed' },
  several: {
    de: 'Mehreres geändert',
    fr: 'Plusieurs choses modifiées',
    it: 'Più cose modificate',
    en: 'Several changes',
  },
  nothing: { de: 'Nichts geändert', fr: 'Rien n’a changé', it: 'Niente è cambiato', en: 'Nothing changed' },
  selected: { de: 'Gewählt: {what}', fr: 'Sélectionné : {what}', it: 'Selezionato: {what}', en: 'Selected: {what}' },
  selectedMany: {
    de: '{count} Dinge gewählt',
    fr: '{count} objets sélectionnés',
    it: '{count} oggetti selezionati',
    en: '{count} things selected',
  },
  deselected: {
    de: 'Nichts gewählt',
    fr: 'Rien n’est sélectionné',
    it: 'Niente è selezionato',
    en: 'Nothing selected',
  },
  robotStart: {
    de: 'Start des Roboters bei {at} cm',
    fr: 'Départ du robot à {at} cm',
    it: 'Partenza del robot a {at} cm',
    en: 'Start of the robot at {at} cm',
  },
} as const satisfies Readonly<Record<string, Texts>>;

/** What happened in the editor as a sentence for screen readers. */
export function wordsFor(happened: Happened): string {
  switch (happened.type) {
    case 'edit':
      return changeWords(happened.before, happened.after, happened.edit);
    // What was taken back is what had been done, not its reverse.
    case 'undo':
      return say(texts.undone, { what: changeWords(happened.after, happened.before) });
    case 'redo':
      return say(texts.redone, { what: changeWords(happened.before, happened.after) });
    case 'problem':
      return say(panelTexts.tooMuch);
    case 'selected':
      return selectionWords(happened.scene, happened.selection);
    case 'tool':
      return say(toolTexts[happened.tool].about);
    default:
      return happened satisfies never;
  }
}

const changeWords = (before: Scene, after: Scene, edit: SceneEdit | null = null): string =>
  descriptionWords(describeChange(before, after, edit));

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
      return say(texts.sized, { what: say(kindTexts[it.kind].one), x: cm(it.size[0]), y: cm(it.size[1]) });
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
  return say(texts.selected, { what: `${namesOf(scene).get(object.id) ?? ''}, ${whereText(object)}` });
}
