import type { Texts } from '#core/texts';
import type { FieldName } from '#editor/object-fields';
import type { SceneObject, StrokeColor } from '#scene/scene';

import { say } from '../i18n/say';
import { optionTexts } from './course-editor-texts';

/** What the fields of an object are called. */
export const fieldTexts: Readonly<Record<FieldName, Texts>> = {
  x: { de: 'x', en: 'x' },
  y: { de: 'y', en: 'y' },
  endX: { de: 'Ende x', en: 'End x' },
  endY: { de: 'Ende y', en: 'End y' },
  width: { de: 'Länge', en: 'Length' },
  height: { de: 'Breite', en: 'Width' },
  turn: { de: 'Gedreht', en: 'Turned' },
  thickness: { de: 'Dicke', en: 'Thickness' },
  penWidth: { de: 'Strichbreite', en: 'Line width' },
  number: { de: 'Nummer', en: 'Number' },
  blocks: { de: 'Blöcke', en: 'Blocks' },
  speed: { de: 'Tempo', en: 'Speed' },
  letterHeight: { de: 'Schrifthöhe', en: 'Letter height' },
  heading: { de: 'Richtung', en: 'Heading' },
  scale: { de: 'Grösse', en: 'Size' },
  round: { de: 'Rund', en: 'Round' },
  spiked: { de: 'Mit Stacheln', en: 'With spikes' },
  color: { de: 'Farbe', en: 'Colour' },
  text: { de: 'Text', en: 'Text' },
  type: { de: 'Art', en: 'Kind' },
};

/** A colour or a kind in words. */
export function valueText(value: StrokeColor | SceneObject['type']): string {
  return value in optionTexts ? say(optionTexts[value as keyof typeof optionTexts]) : value;
}
