import { STANDING_TAG_MM, tagOutline } from '#scene/kinds/tag';
import { tagSheetMm } from '#scene/kinds/tag-thing';
import { sceneDefaults, sceneLimits, type Scene, type Tag } from '#scene/scene';
import { countField, lengthField, placeFields, turnField } from '../object-fields';
import { plus, rotationDeg, toVec, turned } from '../plane';
import { placed } from './box';
import { hitWithin, mirroredDeg, scaledPoint, type EditorKind } from './kind';

/** Tags: moved and turned; they keep their size, as the printed ones do. */
export const tag: EditorKind<Tag> = {
  layer: 3,
  ...placed,
  ...hitWithin<Tag>(tagOutline),
  extentMm: ({ side }) => tagSheetMm(side),
  mirrored(tag, axis, atMm) {
    const mirrored = placed.mirrored(tag, axis, atMm);
    return tag.flat ? mirrored : { ...mirrored, angle: rotationDeg(mirroredDeg(tag.angle, axis)) };
  },
  scaled: (tag, about, factor) => ({ ...tag, at: scaledPoint(tag.at, about, factor) }),
  handles: ({ id, at, side, angle, flat }, reachMm) => {
    const ahead = (flat ? tagSheetMm(side) : STANDING_TAG_MM) / 2 + 2 * reachMm;
    return [{ kind: 'rotate', at: plus(toVec(at), turned({ x: ahead, y: 0 }, angle)), id }];
  },
  fields: (tag) => [
    countField('number', tag.number, sceneLimits.tag, (number) => ({ ...tag, number })),
    lengthField('side', tag.side, sceneLimits.tagMm, 5, (side) => ({ ...tag, side })),
    { kind: 'switch', name: 'flat', value: tag.flat === true, with: (isFlat: boolean) => withFlat(tag, isFlat) },
    ...placeFields(tag, tag.at, placed.moved),
    turnField(tag),
  ],
  made: (id, at, scene) => ({
    type: 'tag',
    id,
    at,
    number: nextNumber(scene),
    side: sceneDefaults.tagSide,
    angle: 180,
  }),
};

function withFlat(tag: Tag, isFlat: boolean): Tag {
  const { flat: _flat, ...rest } = tag;
  return isFlat ? { ...rest, flat: true } : rest;
}

/** The lowest number that no tag of the course has. */
function nextNumber({ objects }: Scene): number {
  const taken = new Set(objects.map((object) => (object.type === 'tag' ? object.number : 0)));
  let number = sceneLimits.tag.min;
  while (taken.has(number) && number < sceneLimits.tag.max) number += 1;
  return number;
}
