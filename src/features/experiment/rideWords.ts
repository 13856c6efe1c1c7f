/** Words of a ride's commands, which come with their field. */
export const rideWords = {
  label: 'commands of the ride, one on each line',
  note: (names: string) =>
    `A time in s, a command and, where it is not 1, how much of it: "3 left 0.5". Commands: ${names}. Applied when you leave the field.`,
  line: (line: number, message: string) => `Line ${line}: ${message}`,
};
