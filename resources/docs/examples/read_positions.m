% SPDX-License-Identifier: Apache-2.0
% [time_s, position_m] = read_positions(PATH, JOINT): positions of one joint over time, for MATLAB and Octave; without
% JOINT of the last one. Neither reads SQLite by itself, so PATH is no take but a table that was exported from it:
% noctule --batch export TAKE.noctule --csv PATH
function [time_s, position_m] = read_positions(path, joint)
    file = fopen(path);
    if file < 0, error('%s cannot be opened', path); end
    names = strsplit(strtrim(fgetl(file)), ',');
    fclose(file);
    if nargin < 2, joint = regexprep(names{end}, '\.[^.]*$', ''); end
    column = find(strcmp(names, strcat(joint, '.x')), 1);
    if isempty(column), error('%s has no joint %s', path, joint); end
    values = dlmread(path, ',', 1, 0);
    time_s = values(:, 1);
    position_m = values(:, column:column + 2);
end
