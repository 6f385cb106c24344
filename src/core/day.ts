/** A day of the calendar, as `2026-11-30`: its order as text is that of time. */
export type Day = string;

/** A day by its numbers, months from 1. */
export function dayOf(year: number, month: number, date: number): Day {
  const digits = (number: number, count: number): string => String(number).padStart(count, '0');
  return `${digits(year, 4)}-${digits(month, 2)}-${digits(date, 2)}`;
}

/** Days before the first of each month in a year that is not a leap year. */
const BEFORE = [0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334] as const;

const isLeap = (year: number): boolean => year % 4 === 0 && (year % 100 !== 0 || year % 400 === 0);

/** Days from 0001-01-01, a Monday, to the first day of a year. */
function daysBefore(year: number): number {
  const past = year - 1;
  return past * 365 + Math.floor(past / 4) - Math.floor(past / 100) + Math.floor(past / 400);
}

/** Days since 0001-01-01, a Monday, in today's calendar; `null`: there is no such day. */
export function dayNumber(day: Day): number | null {
  const [, years, months, days] = /^(\d{4})-(\d\d)-(\d\d)$/.exec(day) ?? [];
  if (years === undefined || months === undefined || days === undefined) return null;
  const [year, month, date] = [Number(years), Number(months), Number(days)];
  const start = BEFORE[month - 1];
  if (year === 0 || start === undefined) return null;
  const length = (BEFORE[month] ?? 365) - start + (month === 2 && isLeap(year) ? 1 : 0);
  if (date < 1 || date > length) return null;
  return daysBefore(year) + start + (month > 2 && isLeap(year) ? 1 : 0) + date - 1;
}

/** Number of the week that a day lies in, from 1, and the year that the week belongs to (ISO 8601). @param day one that there is */
export function weekOf(day: Day): { readonly year: number; readonly week: number } {
  const number = dayNumber(day) ?? 0;
  const thursday = number - (number % 7) + 3; // its year is that of the week
  let year = Number(day.slice(0, 4)) - 1;
  while (daysBefore(year + 1) <= thursday) year += 1;
  return { year, week: Math.floor((thursday - daysBefore(year)) / 7) + 1 };
}
