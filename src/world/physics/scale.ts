import type { Vec } from '#core/geometry';
import { Vec2 } from './planck';

/**
 * Lengths inside the engine: 50 units per metre. Chosen: a 5 cm block is 2.5 units, inside the 0.1 … 10 the engine is
 * made for, and its contact skin is 0.2 mm per body. Mass stays in g and time in s.
 */
export const UNITS_PER_MM = 0.05;
export const MM_PER_UNIT = 20;

/** 1 N = 1000 g · 1000 mm/s². */
export const UNITS_PER_NEWTON = 1000 * 1000 * UNITS_PER_MM;

/** Standard gravity, 9.80665 m/s², in units/s². */
export const GRAVITY = 9806.65 * UNITS_PER_MM;

/** A point of the engine from one in mm. */
export const toUnits = (point: Vec): Vec2 => new Vec2(point.x * UNITS_PER_MM, point.y * UNITS_PER_MM);
