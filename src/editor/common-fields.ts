import type { SceneEdit } from '#scene/edit';
import type { Scene, SceneObject } from '#scene/scene';
import { changing } from './edits';
import { fieldsOf } from './kinds/index';
import { fitting } from './object-edits';
import type { Field, FieldName, FieldValue } from './object-fields';
import { freeObjects } from './selection';
import type { Selection } from './tools/tool';

/** A field that several objects have; `isMixed`: not all have the same value there. */
export interface CommonField {
  readonly field: Field<SceneObject>;
  readonly isMixed: boolean;
}

/** The fields that each object has for itself: places (they are moved and aligned), numbers in an order, words. */
const OWN: ReadonlySet<FieldName> = new Set(['x', 'y', 'endX', 'endY', 'number', 'text', 'name']);

/** The fields that all selected objects share, with the range that suits all; none for fewer than two. */
export function commonFields(scene: Scene, selection: Selection): readonly CommonField[] {
  const [first, ...others] = freeObjects(scene, selection).map(fieldsOf);
  if (!first || others.length === 0) return [];
  return first.flatMap((field) => {
    if (OWN.has(field.name) || isNumbered(field)) return [];
    const same = others.flatMap((fields) => fields.find((other) => isAlike(other, field)) ?? []);
    if (same.length < others.length) return [];
    return { field: narrowed(field, same), isMixed: same.some(({ value }) => value !== field.value) };
  });
}

/** True for the field that can make a zone a checkpoint, which needs a number of its own. */
const isNumbered = (field: Field): boolean => field.name === 'type' && field.choices.includes('checkpoint');

const isAlike = (one: Field, other: Field): boolean =>
  one.name === other.name &&
  one.kind === other.kind &&
  (one.kind !== 'choice' ||
    other.kind !== 'choice' ||
    one.choices.some((choice) => other.choices.some((it) => it === choice)));

/** A field with the range that suits all. Choices are not narrowed: an object that lacks one does not change. */
function narrowed(field: Field<SceneObject>, others: readonly Field[]): Field<SceneObject> {
  if (field.kind !== 'number') return field;
  const numbers = others.filter((other) => other.kind === 'number');
  return {
    ...field,
    min: Math.max(field.min, ...numbers.map(({ min }) => min)),
    max: Math.min(field.max, ...numbers.map(({ max }) => max)),
  };
}

/** Sets a field of all selected objects in one edit; `null` when nothing changes. */
export function withCommonField(
  scene: Scene,
  selection: Selection,
  name: FieldName,
  value: FieldValue,
): SceneEdit | null {
  return changing(
    freeObjects(scene, selection).flatMap((object) => {
      const field = fieldsOf(object).find((one) => one.name === name);
      const fit = field ? fitting(field, value) : null;
      if (!field || fit === null || fit === field.value) return [];
      return field.with(fit, scene) ?? [];
    }),
  );
}
