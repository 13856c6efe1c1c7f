/**
 * First of the rows within [from, to], and the one after the last.
 *
 * @param t times, s, never falling
 * @param from first time, s
 * @param to last time, s
 */
export function rowsWithin(t: Float64Array, from: number, to: number): [number, number] {
  const firstWhere = (beyond: (time: number) => boolean): number => {
    let [low, high] = [0, t.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (beyond(t[middle]!)) high = middle;
      else low = middle + 1;
    }
    return low;
  };
  return [firstWhere((time) => time >= from), firstWhere((time) => time > to)];
}
