import type { Texts } from '#core/texts';
import type { FieldName } from '#editor/object-fields';
import type { SceneObject, StrokeColor } from '#scene/scene';

import { say } from '../../page/i18n/say';
import { optionTexts } from './course-editor-texts';

/** What the fields of an object are called. */
export const fieldTexts: Readonly<Record<FieldName, Texts>> = {
  x: { de: 'x', fr: 'x', it: 'x', en: 'x' },
  y: { de: 'y', fr: 'y', it: 'y', en: 'y' },
  endX: { de: 'Ende x', fr: 'Fin x', it: 'Fine x', en: 'End x' },
  endY: { de: 'Ende y', fr: 'Fin y', it: 'Fine y', en: 'End y' },
  width: { de: 'Länge', fr: 'Longueur', it: 'Lunghezza', en: 'Length' },
  height: { de: 'Breite', fr: 'Largeur', it: 'Larghezza', en: 'Width' },
  turn: { de: 'Gedreht', fr: 'Tourné', it: 'Ruotato', en: 'Turned' },
  thickness: { de: 'Dicke', fr: 'Épaisseur', it: 'Spessore', en: 'Thickness' },
  penWidth: { de: 'Strichbreite', fr: 'Largeur du trait', it: 'Larghezza del tratto', en: 'Line width' },
  number: { de: 'Nummer', fr: 'Numéro', it: 'Numero', en: 'Number' },
  blocks: { de: 'Blöcke', fr: 'Blocs', it: 'Blocchi', en: 'Blocks' },
  speed: { de: 'Tempo', fr: 'Vitesse', it: 'Velocità', en: 'Speed' },
  letterHeight: { de: 'Schrifthöhe', fr: 'Hauteur des lettres', it: 'Altezza delle lettere', en: 'Letter height' },
  heading: { de: 'Richtung', fr: 'Direction', it: 'Direzione', en: 'Heading' },
  scale: { de: 'Grösse', fr: 'Taille', it: 'Grandezza', en: 'Size' },
  round: { de: 'Rund', fr: 'Rond', it: 'Rotondo', en: 'Round' },
  spiked: { de: 'Mit Stacheln', fr: 'Avec des pics', it: 'Con punte', en: 'With spikes' },
  color: { de: 'Farbe', fr: 'Couleur', it: 'Colore', en: 'Colour' },
  text: { de: 'Text', fr: 'Texte', it: 'Testo', en: 'Text' },
  type: { de: 'Art', fr: 'Genre', it: 'Tipo', en: 'Kind' },
};

/** A colour or a kind in words. */
export function valueText(value: StrokeColor | SceneObject['type']): string {
  return value in optionTexts ? say(optionTexts[value as keyof typeof optionTexts]) : value;
}
