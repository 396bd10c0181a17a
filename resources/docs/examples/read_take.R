# SPDX-License-Identifier: Apache-2.0
# Rscript read_take.R TAKE.noctule [JOINT [SUIT]]: poses of the newest result, of suit 1; packages RSQLite and jsonlite.
words <- commandArgs(trailingOnly = TRUE)
take <- DBI::dbConnect(RSQLite::SQLite(), words[1], flags = RSQLite::SQLITE_RO)
suit <- if (length(words) > 2) as.integer(words[3]) else 1L
of_suit <- function(table)  # takes of one suit may lack the column
  if ("suit" %in% DBI::dbListFields(take, table)) paste("suit =", suit) else as.character(as.integer(suit == 1))
actor <- jsonlite::fromJSON(DBI::dbGetQuery(take, paste("SELECT json FROM actor WHERE", of_suit("actor"),
    "ORDER BY id DESC LIMIT 1"))$json)
joints <- actor$joints$name
joint <- match(if (length(words) > 1) words[2] else tail(joints, 1), joints)
pose <- DBI::dbGetQuery(take, paste("SELECT CAST(time_ns AS REAL) AS time_ns, px, py, pz, q FROM pose WHERE",
    of_suit("pose"), "AND run = (SELECT max(run) FROM pose WHERE", of_suit("pose"), ") ORDER BY pose.time_ns"))
for (n in seq_len(nrow(pose))) {
  q <- readBin(pose$q[[n]], "double", 4 * length(joints), endian = "little")[4 * joint - 3:0]
  cat(sprintf("%.4f %.4f %.4f %.4f %.6f %.6f %.6f %.6f\n", pose$time_ns[n] / 1e9, pose$px[n], pose$py[n], pose$pz[n],
    q[1], q[2], q[3], q[4]))
}
