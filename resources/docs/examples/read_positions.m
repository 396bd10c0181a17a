# SPDX-License-Identifier: Apache-2.0
# octave read_positions.m POSITIONS.csv [JOINT]: positions of one joint over time. Octave reads no SQLite by itself, so
# write the table first: noctule --batch export TAKE.noctule --csv POSITIONS.csv
words = argv();
file = fopen(words{1});
names = strsplit(strtrim(fgetl(file)), ",");
fclose(file);
values = dlmread(words{1}, ",", 1, 0);
column = numel(names) - 2;
if numel(words) > 1, column = find(strcmp(names, [words{2} ".x"])); end
printf("%.4f %.4f %.4f %.4f\n", values(:, [1 column column + 1 column + 2])');
